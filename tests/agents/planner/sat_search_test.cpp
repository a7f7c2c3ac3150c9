#include "agents/planner/optimal/sat_search.hpp"

#include <algorithm>

#include "agents/planner/task/grounding.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/planner/engine_contract.hpp"

namespace pizarra::planner {
namespace {

// Where some actions, taken at random, lead to.
Bits wander(const Problem& problem, const Bits& from, std::size_t actions, Random& random) {
  Bits state = from;
  for (std::size_t i = 0; i < actions; ++i) {
    std::vector<std::size_t> possible;
    for (std::size_t action = 0; action < problem.actions.size(); ++action) {
      if (applicable(problem.actions[action], state)) possible.push_back(action);
    }
    if (possible.empty()) break;
    apply(problem.actions[possible[random.below(possible.size())]], state);
  }
  return state;
}

void expect_plan(const Problem& problem, const Outcome& outcome) {
  Bits state = problem.initials;
  for (const std::vector<std::size_t>& step : outcome.steps) {
    for (const std::size_t action : step) {
      ASSERT_TRUE(applicable(problem.actions[action], state)) << write(problem.actions[action].name);
      for (const std::size_t other : step) {
        EXPECT_TRUE(action == other || !interfere(problem.actions[action], problem.actions[other]));
      }
    }
    for (const std::size_t action : step) apply(problem.actions[action], state);
  }
  EXPECT_TRUE(problem.goals.subset_of(state));
}

// One search from state after state, and a new one for each of them.
void expect_the_same_lengths(std::uint64_t seed, const PlanningTask& task, const Budget& budget) {
  Problem problem = ground(task).value();
  const Exclusions exclusions(problem);
  if (!exclusions.allow(problem.goals)) return;
  const Bits first = problem.initials;
  SatSearch kept(problem, exclusions);
  Random random(seed);
  for (int change = 0; change < 10 && !testing::Test::HasFailure(); ++change) {
    SCOPED_TRACE(fmt::format("change {}", change));
    problem.initials = wander(problem, random.below(2) == 0 ? first : problem.initials, random.below(6), random);
    const Outcome known = kept.run(1, budget, never);
    const Outcome anew = SatSearch(problem, exclusions).run(1, budget, never);
    ASSERT_EQ(known.kind, anew.kind);
    EXPECT_EQ(known.steps.size(), anew.steps.size());
    if (known.kind == Outcome::Kind::plan) expect_plan(problem, known);
  }
}

template <class Make>
void expect_the_same_lengths(std::uint64_t seeds, Make make, const Budget& budget = {}) {
  std::uint64_t seed = 0;
  for_random_tasks(seeds, make, [&](const PlanningTask& task) { expect_the_same_lengths(++seed, task, budget); });
}

TEST(SatSearch, FindsNoLongerPlansWithWhatItLearnedFromOtherStates) {
  expect_the_same_lengths(60, [](Random& random) { return random_blocks(3 + random.below(4), random); });
  expect_the_same_lengths(60, random_logistics);
  expect_the_same_lengths(60, random_gripper);
  expect_the_same_lengths(150, random_nonsense);
  expect_the_same_lengths(60, random_conditions);
}

TEST(SatSearch, LearnsAnewWhereWhatItHasLearnedTakesTooMuchMemory) {
  Random random(3);
  const PlanningTask task = random_logistics(random);
  const Problem problem = ground(task).value();
  const Exclusions exclusions(problem);
  std::size_t enough = 1 << 14;  // for the clauses of one search
  while (SatSearch(problem, exclusions).run(1, {.bytes = enough}, never).kind != Outcome::Kind::plan) enough += 1 << 14;
  SatSearch kept(problem, exclusions);
  for (int again = 0; again < 20; ++again) {
    EXPECT_EQ(kept.run(1, {.bytes = enough}, never).kind, Outcome::Kind::plan) << "time " << again;
  }
}

TEST(SatSearch, GoesOnWhereItWasCancelled) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const Problem problem = ground(random_logistics(random)).value();
    const Exclusions exclusions(problem);
    if (problem.goals.subset_of(problem.initials) || !exclusions.allow(problem.goals)) continue;
    SatSearch search(problem, exclusions);
    int looks = static_cast<int>(random.below(8));
    search.run(1, {}, [&] { return --looks < 0; });
    const Outcome outcome = search.run(1, {}, never);
    EXPECT_EQ(outcome.steps.size(), SatSearch(problem, exclusions).run(1, {}, never).steps.size());
  }
}

TEST(SatSearch, WorksLessFromAStateNearOneItKnows) {
  std::size_t again = 0;
  std::size_t anew = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    Problem problem = ground(random_blocks(8, random)).value();
    const Exclusions exclusions(problem);
    SatSearch kept(problem, exclusions);
    kept.run(1, {}, never);
    problem.initials = wander(problem, problem.initials, 1, random);
    again += kept.run(1, {}, never).nodes;
    anew += SatSearch(problem, exclusions).run(1, {}, never).nodes;
  }
  EXPECT_LT(2 * again, anew);
}

}  // namespace
}  // namespace pizarra::planner
