// A domain that extends another one: what it takes, replaces, adds and leaves out, and where its errors stand.

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "lisp/forms/domain.hpp"
#include "lisp/writer.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

std::string written(const std::string& name, const std::string& text) {
  std::ofstream(scratch_folder() + name) << text;
  return scratch_folder() + name;
}

constexpr const char* base =
    "(domain base\n"
    "  (types OBJECT)\n"
    "  (predicates (held (ob OBJECT)) (lying (ob OBJECT)) (odd (ob OBJECT)))\n"
    "  (objects (stone OBJECT))\n"
    "  (facts (lying stone) (odd stone))\n"
    "  (operator LIFT (params (<ob> OBJECT)) (preconds (lying <ob>))\n"
    "    (effects (held <ob>) (odd <ob>) (del (lying <ob>))))\n"
    "  (operator LAY (params (<ob> OBJECT)) (preconds (held <ob>)) (effects (lying <ob>) (del odd <ob>)))\n"
    "  (perception (sees OBJECT) (constant cube 60) (fact (spot a 1 2)) (fact (spot b 3 4))\n"
    "    (rule (held ?o) (seen ?o)) (rule (held ?o) (unseen ?o) (was (held ?o))) (rule (lying ?o) (seen ?o)))\n"
    "  (micro-tasks (GRASP (<ob>) (close)) (LIFT (<ob>) (GRASP <ob>)) (LAY (<ob>) (release))))\n";

// The domain that `sections` make of the base.
Result<forms::Domain> variant(const std::string& sections) {
  written("base.scm", base);
  return forms::read_domain_file(
      written("variant.scm", "(domain variant\n  (extends \"base.scm\")\n  " + sections + ")\n"));
}

std::string report(const Result<forms::Domain>& domain) {
  return domain ? "it was read" : domain.error().symbol + ": " + describe(domain.error());
}

TEST(DomainExtension, TakesAllOfTheOther) {
  const Result<forms::Domain> domain = variant("");
  const Result<forms::Domain> other = forms::read_domain_file(scratch_folder() + "base.scm");
  ASSERT_TRUE(domain && other) << report(domain) << report(other);
  EXPECT_EQ(domain->name, "variant");
  EXPECT_EQ(domain->types, other->types);
  EXPECT_EQ(domain->facts, other->facts);
  EXPECT_EQ(domain->objects, other->objects);
  EXPECT_EQ(domain->predicates.size(), 3u);
  EXPECT_EQ(domain->operators.size(), 2u);
  EXPECT_EQ(domain->perception, other->perception);
  EXPECT_EQ(domain->micro_tasks, other->micro_tasks);
}

TEST(DomainExtension, ReplacesByNameAndAddsTheRest) {
  const Result<forms::Domain> domain = variant(
      "(types TOOL OBJECT) (predicates (lying (what TOOL)) (free (tool TOOL)))\n"
      "  (objects (stone TOOL)) (facts (lying stone))\n"
      "  (operator LIFT (effects (odd stone))) (operator LAY (effects (odd stone)))");
  ASSERT_FALSE(domain);  // odd is said of an OBJECT
  const Result<forms::Domain> fitting = variant(
      "(types TOOL) (predicates (free (tool TOOL))) (objects (drill TOOL)) (facts (free drill) (lying stone))\n"
      "  (operator LIFT (effects (odd stone)))");
  ASSERT_TRUE(fitting) << report(fitting);
  EXPECT_EQ(fitting->types, (std::vector<std::string>{"OBJECT", "TOOL"}));
  EXPECT_EQ(fitting->objects, (std::vector<forms::TypedName>{{"stone", "OBJECT"}, {"drill", "TOOL"}}));
  EXPECT_EQ(write(Datum::list(fitting->facts)), "((free drill) (lying stone) (odd stone))");
  ASSERT_EQ(fitting->operators.size(), 2u);
  EXPECT_EQ(write(forms::operator_form(fitting->operators[0])),
            "(operator LIFT (params) (preconds) (effects (odd stone)))");
}

TEST(DomainExtension, RulesAndMicroTasksKeepTheirOrder) {
  const Result<forms::Domain> domain = variant(
      "(perception (constant cube 40) (constant rim 5) (fact (spot c 5 6)) (rule (odd ?o) (seen ?o))\n"
      "    (rule (held ?o) (odd ?o)) (rule (last ?o) (held ?o)))\n"
      "  (micro-tasks (NUDGE (<ob>) (raise)) (GRASP (<ob>) (NUDGE <ob>)))");
  ASSERT_TRUE(domain) << report(domain);
  EXPECT_EQ(write(domain->perception),
            "(perception (sees OBJECT) (constant cube 40) (constant rim 5) (fact (spot c 5 6)) "
            "(rule (odd ?o) (seen ?o)) (rule (held ?o) (odd ?o)) (rule (lying ?o) (seen ?o)) "
            "(rule (last ?o) (held ?o)))");
  EXPECT_EQ(write(domain->micro_tasks),
            "(micro-tasks (NUDGE (<ob>) (raise)) (GRASP (<ob>) (NUDGE <ob>)) (LIFT (<ob>) (GRASP <ob>)) "
            "(LAY (<ob>) (release)))");
}

TEST(DomainExtension, LeavesOutANameAndWhatOperatorsDoToIt) {
  const Result<forms::Domain> domain = variant("(without odd spot)");
  ASSERT_TRUE(domain) << report(domain);
  EXPECT_EQ(domain->find_predicate("odd"), nullptr);
  EXPECT_EQ(write(Datum::list(domain->facts)), "((lying stone))");
  ASSERT_EQ(domain->operators.size(), 2u);
  EXPECT_EQ(write(Datum::list(domain->operators[0].adds)), "((held ?ob))");
  EXPECT_EQ(domain->operators[1].deletes, std::vector<Datum>());
  EXPECT_EQ(write(domain->perception),
            "(perception (sees OBJECT) (constant cube 60) (rule (held ?o) (seen ?o)) "
            "(rule (held ?o) (unseen ?o) (was (held ?o))) (rule (lying ?o) (seen ?o)))");
}

TEST(DomainExtension, LeavesOutAnOperatorWithItsMicroTask) {
  const Result<forms::Domain> domain = variant("(without LAY)");
  ASSERT_TRUE(domain) << report(domain);
  EXPECT_EQ(domain->operators.size(), 1u);
  EXPECT_EQ(write(domain->micro_tasks), "(micro-tasks (GRASP (<ob>) (close)) (LIFT (<ob>) (GRASP <ob>)))");
}

TEST(DomainExtension, AnErrorStandsInTheFileThatHoldsIt) {
  const std::string inherited = report(variant("(without lying)"));
  EXPECT_NE(inherited.find("there is no predicate lying"), std::string::npos) << inherited;
  EXPECT_NE(inherited.find("base.scm:6:"), std::string::npos) << inherited;
  EXPECT_NE(inherited.find("(preconds (lying <ob>))"), std::string::npos) << inherited;
  EXPECT_EQ(inherited.find("variant.scm"), std::string::npos) << inherited;
  const std::string own = report(variant("(facts (lyin stone)) (facts)"));
  EXPECT_NE(own.find("variant.scm:3:11"), std::string::npos) << own;
  EXPECT_NE(own.find("there is a section facts already"), std::string::npos) << own;
  EXPECT_EQ(own.find("base.scm"), std::string::npos) << own;
}

TEST(DomainExtension, OfBothFilesAllIsReportedTogether) {
  const std::string both = report(variant("(without lying) (operator DROP (effects (lies stone)))"));
  EXPECT_NE(both.find("base.scm:6:"), std::string::npos) << both;
  EXPECT_NE(both.find("variant.scm:3:"), std::string::npos) << both;
}

TEST(DomainExtension, PathsAreThoseOfTheFileThatSaysThem) {
  std::filesystem::create_directories(scratch_folder() + "deep/deeper");
  written("base.scm", base);
  written("deep/middle.scm", "(domain middle (extends \"../base.scm\") (types MIDDLE))");
  const Result<forms::Domain> domain = forms::read_domain_file(
      written("deep/deeper/top.scm", "(domain top (extends \"../middle.scm\") (types TOP) (without odd))"));
  ASSERT_TRUE(domain) << report(domain);
  EXPECT_EQ(domain->types, (std::vector<std::string>{"OBJECT", "MIDDLE", "TOP"}));
  const std::string wrong = report(forms::read_domain_file(
      written("deep/deeper/top.scm", "(domain top (extends \"../middle.scm\") (without lying))")));
  EXPECT_NE(wrong.find("there is no predicate lying"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("base.scm:6:"), std::string::npos) << wrong;
}

TEST(DomainExtension, ACircleIsOneError) {
  written("one.scm", "(domain one\n  (extends \"two.scm\"))");
  written("two.scm", "(domain two\n  (extends \"./one.scm\"))");
  const std::string circle = report(forms::read_domain_file(scratch_folder() + "one.scm"));
  EXPECT_NE(circle.find("extends-itself: a domain cannot extend itself: one.scm extends two.scm extends one.scm"),
            std::string::npos)
      << circle;
  EXPECT_NE(circle.find("two.scm:2:3"), std::string::npos) << circle;
}

TEST(DomainExtension, AFileThatIsMissingOrIsNoDomainIsOneError) {
  const Result<forms::Domain> missing =
      forms::read_domain_file(written("a.scm", "(domain a\n  (extends \"b/no.scm\"))"));
  EXPECT_NE(report(missing).find("unreadable-file: there is no file " + scratch_folder() + "b/no.scm"),
            std::string::npos)
      << report(missing);
  EXPECT_NE(report(missing).find("a.scm:2:3"), std::string::npos) << report(missing);
  written("cell.scm", "(cell c)");
  const std::string cell = report(forms::read_domain_file(written("a.scm", "(domain a (extends \"cell.scm\"))")));
  EXPECT_NE(cell.find("wrong-file: only a form (domain ...) can be extended"), std::string::npos) << cell;
  EXPECT_NE(cell.find("cell.scm:1:1"), std::string::npos) << cell;
  written("open.scm", "(domain open");
  const std::string open = report(forms::read_domain_file(written("a.scm", "(domain a (extends \"open.scm\"))")));
  EXPECT_NE(open.find("unclosed-list"), std::string::npos) << open;
  EXPECT_NE(open.find("open.scm:1:1"), std::string::npos) << open;
}

TEST(DomainExtension, EightFilesMayExtendOneAnother) {
  written("chain-1.scm", base);
  for (int i = 2; i <= 9; ++i) {
    written(fmt::format("chain-{}.scm", i), fmt::format("(domain d{}\n  (extends \"chain-{}.scm\"))", i, i - 1));
  }
  EXPECT_TRUE(forms::read_domain_file(scratch_folder() + "chain-8.scm"));
  const std::string longer = report(forms::read_domain_file(scratch_folder() + "chain-9.scm"));
  EXPECT_NE(longer.find("too-many: at most 8 files may extend one another"), std::string::npos) << longer;
  EXPECT_NE(longer.find("chain-2.scm:2:3"), std::string::npos) << longer;
}

TEST(DomainExtension, SaysWhichNameCannotBeLeftOut) {
  const std::string wrong = report(variant("(without lyin 7)"));
  EXPECT_NE(wrong.find("the domain that is extended says nothing of lyin; the nearest is lying (and 1 more)"),
            std::string::npos)
      << wrong;
  EXPECT_NE(wrong.find("variant.scm:3:12"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("variant.scm:3:17"), std::string::npos) << wrong;
}

TEST(DomainExtension, RefusesExtensionsThatAreNotWrittenSo) {
  EXPECT_EQ(forms::read_domain("(domain d (extends base.scm))", "d").error().symbol, "malformed");
  EXPECT_EQ(forms::read_domain("(domain d (extends \"\"))", "d").error().symbol, "malformed");
  EXPECT_EQ(forms::read_domain("(domain d (without x))", "d").error().symbol, "malformed");
  EXPECT_EQ(variant("(extends \"base.scm\")").error().symbol, "repeated");
}

}  // namespace
}  // namespace pizarra
