#include "lisp/forms/domain.hpp"

#include <gtest/gtest.h>

#include "lisp/writer.hpp"
#include "tests/source_dir.hpp"

namespace pizarra {
namespace {

const std::string domains = source_dir() + "/domains/";

TEST(DomainTest, ReadsTheBlocks) {
  const auto domain = forms::read_domain_file(domains + "blocks.scm");
  ASSERT_TRUE(domain) << describe(domain.error());
  EXPECT_EQ(domain->name, "blocks");
  for (const char* name : {"PICK-UP", "PUT-DOWN", "STACK", "UNSTACK"}) {
    EXPECT_NE(domain->find_operator(name), nullptr) << name;
  }
  ASSERT_NE(domain->find_predicate("on"), nullptr);
  EXPECT_EQ(domain->find_predicate("on")->arguments.size(), 2u);
  const forms::Operator* stack = domain->find_operator("STACK");
  ASSERT_NE(stack, nullptr);
  EXPECT_EQ(stack->params, (std::vector<forms::TypedName>{{"?ob1", "OBJECT"}, {"?ob2", "OBJECT"}}));
  EXPECT_EQ(write(Datum::list(stack->preconds)), "((clear ?ob2) (holding ?ob1))");
  EXPECT_EQ(write(Datum::list(stack->adds)), "((arm-empty) (clear ?ob1) (on ?ob1 ?ob2))");
  EXPECT_EQ(write(Datum::list(stack->deletes)), "((clear ?ob2) (bare ?ob2) (holding ?ob1))");
  EXPECT_TRUE(domain->perception.is_form("perception"));
  EXPECT_TRUE(domain->micro_tasks.is_form("micro-tasks"));
  const Failure failure = domain->source.failure_at(domain->micro_tasks_path, "odd", "odd");
  EXPECT_EQ(failure.subject, domain->micro_tasks);
}

TEST(DomainTest, ReadsNumberedPlaces) {
  const auto domain = forms::read_domain_file(domains + "numbered-places.scm");
  ASSERT_TRUE(domain) << describe(domain.error());
  ASSERT_FALSE(domain->objects.empty());
  EXPECT_EQ(domain->objects[0], (forms::TypedName{"place-1", "PLACE"}));
}

TEST(DomainTest, AnOperatorIsWrittenInTheThesisSyntaxAgain) {
  const auto domain = forms::read_domain_file(domains + "blocks.scm");
  ASSERT_TRUE(domain);
  EXPECT_EQ(write(forms::operator_form(*domain->find_operator("PUT-DOWN"))),
            "(operator PUT-DOWN (params (<ob1> OBJECT)) (preconds (holding <ob1>)) "
            "(effects (clear <ob1>) (arm-empty) (on-table <ob1>) (del (holding <ob1>))))");
}

TEST(DomainTest, EveryErrorIsReportedWithItsPlace) {
  const auto domain = forms::read_domain(
      "(domain d\n"
      "  (types OBJECT)\n"
      "  (predicates (clear (ob OBJCT)) (holding (ob OBJECT)))\n"
      "  (operator LIFT\n"
      "    (params (<ob1> OBJECT))\n"
      "    (effects (holdin <ob1>) (holding <ob2>))))\n",
      "d.scm");
  ASSERT_FALSE(domain);
  EXPECT_EQ(domain.error().symbol, "unknown-type");
  EXPECT_EQ(describe(domain.error()),
            "there is no type OBJCT; the nearest is OBJECT (and 2 more)\n"
            "d.scm:3:26\n"
            "    (predicates (clear (ob OBJCT)) (holding (ob OBJECT)))\n"
            "                           ^\n"
            "  in the predicates\n"
            "there is no predicate holdin; the nearest is holding\n"
            "d.scm:6:15\n"
            "      (effects (holdin <ob1>) (holding <ob2>))))\n"
            "                ^\n"
            "  in operator LIFT\n"
            "there is no parameter <ob2>; the nearest is <ob1>\n"
            "d.scm:6:38\n"
            "      (effects (holdin <ob1>) (holding <ob2>))))\n"
            "                                       ^\n"
            "  in operator LIFT");
}

TEST(DomainTest, WhatIsNoDomainIsOneFailure) {
  EXPECT_EQ(forms::read_domain("", "d").error().symbol, "malformed");
  EXPECT_EQ(forms::read_domain("(cell d)", "d").error().symbol, "malformed");
  EXPECT_EQ(forms::read_domain("(domain d", "d").error().symbol, "unclosed-list");
  EXPECT_EQ(forms::read_domain_file("/nowhere.scm").error().symbol, "unreadable-file");
}

}  // namespace
}  // namespace pizarra
