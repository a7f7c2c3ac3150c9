// Whatever a person writes, the interpreters answer with a reading or with a report, never with an error of their own.

#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>

#include "lisp/forms/cell_file.hpp"
#include "lisp/forms/domain.hpp"
#include "lisp/forms/goal.hpp"
#include "lisp/forms/micro_tasks.hpp"
#include "lisp/forms/perception.hpp"
#include "lisp/forms/scenario_file.hpp"
#include "lisp/forms/vision_reply.hpp"
#include "lisp/writer.hpp"
#include "tests/lisp/random_datum.hpp"
#include "tests/source_dir.hpp"

namespace pizarra {
namespace {

const std::string root = source_dir() + "/";

// One element somewhere in it is removed, doubled, replaced by something else, or swapped with its neighbour.
Datum damaged(const Datum& datum, RandomDatum& random) {
  if (datum.size() == 0) return random.any(2);
  std::vector<Datum> items(datum.items().begin(), datum.items().end());
  const std::size_t at = random.below(items.size());
  const auto place = items.begin() + static_cast<std::ptrdiff_t>(at);
  if (items[at].is_list() && random.below(4) > 0) {
    items[at] = damaged(items[at], random);
    return Datum::list(std::move(items));
  }
  switch (random.below(4)) {
    case 0:
      items.erase(place);
      break;
    case 1:
      items.insert(place, Datum(items[at]));
      break;
    case 2:
      items[at] = random.any(2);
      break;
    default:
      std::swap(items[at], items[random.below(items.size())]);
  }
  return Datum::list(std::move(items));
}

std::string text_of(const Datum& data) {
  std::string out;
  for (const Datum& datum : data.items()) out += write(datum) + "\n";
  return out;
}

using Interpretation = std::function<Result<void>(const std::string&)>;

template <class Value>
Result<void> outcome_of(const Result<Value>& result) {
  if (!result) return fail(result);
  return {};
}

void survive(const std::vector<Datum>& sound, int times, const Interpretation& interpretation) {
  for (int seed = 1; seed <= times; ++seed) {
    RandomDatum random(static_cast<std::uint64_t>(seed));
    Datum data = Datum::list(sound);
    for (auto changes = 1 + random.below(4); changes > 0; --changes) data = damaged(data, random);
    const std::string text = text_of(data);
    const Result<void> outcome = interpretation(text);
    if (outcome) continue;
    ASSERT_NE(outcome.error().symbol, "scheme-error") << "seed " << seed << "\n" << text << describe(outcome.error());
    ASSERT_FALSE(outcome.error().place.empty()) << "seed " << seed << "\n" << text << describe(outcome.error());
  }
}

std::vector<Datum> data_of(const std::string& path) { return read_source_file(root + path).value().data(); }

TEST(InterpretersTest, DomainsSurviveDamage) {
  for (const char* file : {"domains/blocks.scm", "domains/numbered-places.scm"}) {
    survive(data_of(file), 500,
            [](const std::string& text) { return outcome_of(forms::read_domain(text, "damaged")); });
  }
}

TEST(InterpretersTest, PerceptionAndMicroTasksSurviveDamage) {
  const forms::Domain domain = forms::read_domain_file(root + "domains/blocks.scm").value();
  forms::Arities predicates;
  for (const forms::Predicate& predicate : domain.predicates)
    predicates.emplace_back(predicate.name, predicate.arguments.size());
  forms::Arities operators;
  for (const forms::Operator& one : domain.operators) operators.emplace_back(one.name, one.params.size());
  const forms::Motions motions{.primitives = {{"open", 1},
                                              {"raise", 0},
                                              {"align", 1},
                                              {"lower", 1},
                                              {"close", 0},
                                              {"release", 0},
                                              {"make-room", 1},
                                              {"turn-fingers", 1},
                                              {"square-up", 0},
                                              {"check-held", 1}},
                               .aimed = {"align", "lower"},
                               .targets = {{"on-top", 2}, {"free-spot", 1}}};
  const std::vector<Datum> measured{read_one("(seen circle 450 0 30)").value(), read_one("(gripper 100)").value(),
                                    read_one("(grip 300 0 300)").value()};
  survive(data_of("domains/blocks.scm"), 1000, [&](const std::string& text) -> Result<void> {
    const Source source = read_source(text, "damaged").value();
    const auto tasks = forms::MicroTasks::read(source, operators, motions);
    if (!tasks && tasks.error().symbol == "scheme-error") return outcome_of(tasks);
    const auto perception = forms::Perception::read(source, predicates);
    if (!perception) return outcome_of(perception);
    const auto facts = perception->perceive(measured, {});
    return facts || facts.error().symbol != "scheme-error" ? Result<void>() : outcome_of(facts);
  });
}

TEST(InterpretersTest, CellsSurviveDamage) {
  const auto read = [](const std::string& text) { return outcome_of(forms::read_cell(text, "damaged")); };
  survive(data_of("examples/01-blocks/cell.scm"), 1000, read);
  survive({read_one(R"((cell c (arm ur5e (driver universal "u" 1) (room (z 20 700)) (gripper (driver modbus "g" 502)
                        (unit 9) (opening 0 85) (counts 255 0) (force 20) (registers (go 1000 11 1))))))")
               .value()},
          1000, read);
}

TEST(InterpretersTest, ScenariosSurviveDamage) {
  survive(data_of("tests/scenarios/05-tower-knocked-over.scm"), 1000,
          [](const std::string& text) { return outcome_of(forms::read_scenario(text, "damaged")); });
}

TEST(InterpretersTest, GoalsSurviveDamage) {
  const forms::Domain domain = forms::read_domain_file(root + "domains/blocks.scm").value();
  const Datum goal = read_one("(and (on circle triangle) (on triangle \"square\") (not (holding cross)))").value();
  survive({goal}, 1500, [&](const std::string& text) {
    return outcome_of(
        forms::read_goal(domain, text, {{"circle", "OBJECT"}, {"triangle", "OBJECT"}, {"square", "OBJECT"}}));
  });
  survive({goal}, 500, [&](const std::string& text) { return outcome_of(forms::check_goal(domain, text)); });
}

TEST(InterpretersTest, VisionRepliesSurviveDamage) {
  for (const char* reply : {"(TRACK 2 (\"a\" OK (1 , 2 , 3.5)) (\"b\" FAIL))", "(GET 2 (\"a\" , \"b\"))",
                            "(FIND \"a\" OK (1 , 2))", "(LEARN \"a\" OK)"}) {
    survive({read_one(reply, {.commas = true}).value()}, 500,
            [](const std::string& text) { return outcome_of(forms::interpret_vision_reply(text)); });
  }
}

TEST(InterpretersTest, AHugeDomainIsRefusedSoon) {
  std::string objects;
  std::string facts;
  for (int i = 0; i < 15'000; ++i) {
    objects += fmt::format("(o{} T) ", i);
    facts += fmt::format("(p x{}) ", i);
  }
  const auto huge = forms::read_domain(
      fmt::format("(domain d (types T) (predicates (p (a T))) (objects {}) (facts {}))", objects, facts), "huge");
  ASSERT_FALSE(huge);
  EXPECT_EQ(huge.error().symbol, "too-many");
  EXPECT_LT(huge.error().place.size(), 10'000u);
}

}  // namespace
}  // namespace pizarra
