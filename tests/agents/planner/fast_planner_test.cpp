#include "agents/planner/fast/fast_planner.hpp"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <new>
#include <utility>

#include "agents/planner/distance/nearness.hpp"
#include "agents/planner/fast/hill_climbing.hpp"
#include "agents/planner/fast/plan_reordering.hpp"
#include "agents/planner/judge/breadth_first.hpp"
#include "agents/planner/optimal/optimal_search.hpp"
#include "agents/planner/task/grounding.hpp"
#include "agents/planner/task/idle_actions.hpp"
#include "lisp/writer.hpp"
#include "tests/agents/planner/engine_contract.hpp"
#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra::planner {
namespace {

std::size_t actions_of(const Outcome& outcome) {
  std::size_t actions = 0;
  for (const std::vector<std::size_t>& step : outcome.steps) actions += step.size();
  return actions;
}

PlanningTask random_task(std::uint64_t seed) {
  Random random(seed);
  switch (seed % 4) {
    case 0:
      return random_blocks(2 + random.below(4), random);
    case 1:
      return random_logistics(random);
    case 2:
      return random_gripper(random);
    default:
      return random_nonsense(random);
  }
}

void add_move(PlanningTask& task, const std::string& name, const std::string& carrier, std::string_view where) {
  task.operators.push_back({name,
                            {{"?c", carrier}, {"?from", "PLACE"}, {"?to", "PLACE"}, {"?in", "REGION"}},
                            facts_of(fmt::format("(at ?c ?from) {}", where)),
                            facts_of("(at ?c ?to)"),
                            facts_of("(at ?c ?from)")});
}

// Cities of four places, each with a truck, and one airplane between the first places of them.
PlanningTask deliveries(std::size_t cities, std::size_t parcels, Random& random) {
  PlanningTask task;
  task.types = {{"TRUCK", "CARRIER"}, {"AIRPLANE", "CARRIER"}};
  const std::vector<PlanningParameter> parameters{{"?p", "PARCEL"}, {"?c", "CARRIER"}, {"?l", "PLACE"}};
  const std::vector<Datum> outside = facts_of("(at ?p ?l)"), inside = facts_of("(in ?p ?c)");
  task.operators = {{"LOAD", parameters, facts_of("(at ?p ?l) (at ?c ?l)"), inside, outside},
                    {"UNLOAD", parameters, facts_of("(in ?p ?c) (at ?c ?l)"), outside, inside}};
  add_move(task, "DRIVE", "TRUCK", "(within ?from ?in) (within ?to ?in)");
  add_move(task, "FLY", "AIRPLANE", "(airport ?from ?in) (airport ?to ?in)");
  const auto add_object = [&](const std::string& name, const std::string& type) {
    task.objects.push_back({form(name), type});
  };
  const auto holds = [&](const std::string& fact) { task.initials.push_back(form(fact)); };
  const auto place = [&] { return fmt::format("place{}-{}", random.below(cities), random.below(4)); };
  add_object("world", "REGION");
  add_object("plane", "AIRPLANE");
  holds("(at plane place0-0)");
  for (std::size_t city = 0; city < cities; ++city) {
    add_object(fmt::format("city{}", city), "REGION");
    add_object(fmt::format("truck{}", city), "TRUCK");
    holds(fmt::format("(at truck{0} place{0}-0)", city));
    holds(fmt::format("(airport place{}-0 world)", city));
    for (int i = 0; i < 4; ++i) {
      add_object(fmt::format("place{}-{}", city, i), "PLACE");
      holds(fmt::format("(within place{0}-{1} city{0})", city, i));
    }
  }
  for (std::size_t parcel = 0; parcel < parcels; ++parcel) {
    add_object(fmt::format("p{}", parcel), "PARCEL");
    holds(fmt::format("(at p{} {})", parcel, place()));
    task.goals.push_back(form(fmt::format("(at p{} {})", parcel, place())));
  }
  return task;
}

// Whether the plan leads to the goals.
bool works(const CompactProblem& problem, const std::vector<ActionIndex>& plan) {
  Bits state = problem.initials();
  for (const ActionIndex action : plan) {
    if (!problem.applicable(action, state)) return false;
    problem.apply(action, state);
  }
  return problem.goals().subset_of(state);
}

Budget effort(std::size_t nodes) {
  Budget budget;
  budget.nodes = nodes;
  return budget;
}

TEST(FastPlanner, FindsValidPlansExactlyWhereThereAreSome) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    const PlanningTask task = random_task(seed);
    const Result<Problem> problem = ground(task);
    ASSERT_TRUE(problem);
    const Outcome judged = BreadthFirst().solve(*problem, Budget{}, never);
    const Outcome outcome = FastPlanner({.seed = seed}).solve(*problem, effort(2000), never);
    ASSERT_EQ(outcome.kind, judged.kind) << show(task);
    if (outcome.kind != Outcome::Kind::plan) continue;
    EXPECT_TRUE(validate_plan(task, steps_of(*problem, outcome.steps))) << show(task);
    EXPECT_GE(actions_of(outcome), actions_of(judged)) << show(task);
  }
}

TEST(FastPlanner, EndsWithAShortestPlanWhereABeamLeavesNothingOut) {
  for (std::uint64_t seed = 0; seed < 120; ++seed) {
    SCOPED_TRACE(seed);
    const PlanningTask task = random_task(seed);
    const Problem problem = ground(task).value();
    const Outcome outcome = FastPlanner().solve(problem, effort(1'000'000), never);
    if (outcome.kind != Outcome::Kind::plan || outcome.nodes > 1'000'000) continue;
    EXPECT_EQ(actions_of(outcome), actions_of(BreadthFirst().solve(problem, Budget{}, never))) << show(task);
  }
}

TEST(FastPlanner, TellsOfEveryPlanThatIsShorterAndAnswersTheLast) {
  Random random(5);
  const PlanningTask task = random_blocks(16, random);
  const Problem problem = ground(task).value();
  std::vector<std::size_t> lengths;
  FastPlanner engine({.seed = 1, .better = [&](const Outcome& plan) {
                        lengths.push_back(actions_of(plan));
                        EXPECT_TRUE(validate_plan(task, steps_of(problem, plan.steps)));
                      }});
  const Outcome outcome = engine.solve(problem, effort(100'000), never);
  ASSERT_GT(lengths.size(), 1U);
  for (std::size_t i = 1; i < lengths.size(); ++i) EXPECT_LT(lengths[i], lengths[i - 1]);
  EXPECT_EQ(actions_of(outcome), lengths.back());
}

TEST(FastPlanner, AnswersTheSameForTheSameSeed) {
  for (std::uint64_t seed = 1; seed < 20; ++seed) {
    Random random(seed);
    const Problem problem = ground(random_blocks(10, random)).value();
    const Outcome once = FastPlanner({.seed = seed}).solve(problem, effort(20'000), never);
    const Outcome again = FastPlanner({.seed = seed}).solve(problem, effort(20'000), never);
    EXPECT_EQ(once.steps, again.steps) << seed;
    EXPECT_EQ(once.nodes, again.nodes) << seed;
  }
}

TEST(FastPlanner, StopsWhenCancelledAndAnswersThePlanItHas) {
  Random random(3);
  const Problem problem = ground(random_blocks(30, random)).value();
  EXPECT_EQ(FastPlanner().solve(problem, Budget{}, [] { return true; }).kind, Outcome::Kind::cancelled);

  bool found = false;
  int asked_since = 0;
  FastPlanner engine({.seed = 1, .better = [&](const Outcome&) { found = true; }});
  const Outcome outcome = engine.solve(problem, Budget{}, [&] { return found && ++asked_since > 0; });
  EXPECT_EQ(outcome.kind, Outcome::Kind::plan);
  EXPECT_LE(asked_since, 3);
}

TEST(FastPlanner, PlansForSixtyBlocksWithFewStatesLookedAt) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Random random(seed);
    const PlanningTask task = random_blocks(60, random);
    const Problem problem = ground(task).value();
    const Outcome outcome = FastPlanner({.first_only = true}).solve(problem, effort(200'000), never);
    ASSERT_EQ(outcome.kind, Outcome::Kind::plan) << seed;
    EXPECT_TRUE(validate_plan(task, steps_of(problem, outcome.steps))) << seed;
    EXPECT_LE(actions_of(outcome), 240U) << seed;
  }
}

TEST(FastPlanner, PlansForThirtyParcelsInEightCitiesWithFewStatesLookedAt) {
  for (std::uint64_t seed = 1; seed <= 2; ++seed) {
    Random random(seed);
    const PlanningTask task = deliveries(8, 30, random);
    const Result<Problem> problem = ground(task);
    ASSERT_TRUE(problem) << problem.error().sentence;
    const Outcome outcome = FastPlanner({.first_only = true}).solve(*problem, effort(100'000), never);
    ASSERT_EQ(outcome.kind, Outcome::Kind::plan) << seed;
    EXPECT_TRUE(validate_plan(task, steps_of(*problem, outcome.steps))) << seed;
    EXPECT_LE(actions_of(outcome), 270U) << seed;
  }
}

TEST(FastPlanner, SaysWithoutASearchWhichGoalsOfSixtyBlocksCanNeverHold) {
  for (const char* goals : {"(on b1 b1)", "(on b1 b2) (on b1 b3)"}) {
    Random random(5);
    PlanningTask task = random_blocks(60, random);
    task.goals = facts_of(goals);
    const Problem problem = ground(task).value();
    FastPlanner engine;
    const Outcome outcome = engine.solve(problem, Budget{.nodes = 0}, [] { return false; });
    ASSERT_EQ(outcome.kind, Outcome::Kind::none) << goals;
    std::vector<Datum> culprits;
    for (const std::size_t fact : outcome.culprits) culprits.push_back(problem.facts[fact]);
    EXPECT_EQ(culprits, task.goals);
  }
}

TEST(HillClimbing, FindsPlansThatWorkForMostProblemsThatHaveOne) {
  int with_plan = 0, found = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Problem problem = ground(random_task(seed)).value();
    const CompactProblem compact(problem);
    const Budget budget = effort(100'000);
    SearchBudget spent(budget, never);
    HillClimbing climbing(compact, spent);
    if (climbing.run() == SearchEnd::found) {
      ASSERT_TRUE(works(compact, climbing.plan())) << seed;
      ++found;
    }
    with_plan += BreadthFirst().solve(problem, Budget{}, never).kind == Outcome::Kind::plan ? 1 : 0;
  }
  EXPECT_GT(found, with_plan * 3 / 4) << with_plan;
}

TEST(RelaxedPlan, IsEmptyWhereTheGoalsHoldAndHelpsWithWhatCanBeDone) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const Problem problem = ground(random_task(seed)).value();
    const CompactProblem compact(problem);
    RelaxedPlan relaxed(compact);
    const bool reachable = relaxed.look_at(problem.initials);
    const bool has_plan = BreadthFirst().solve(problem, Budget{}, never).kind == Outcome::Kind::plan;
    ASSERT_TRUE(reachable || !has_plan) << seed;
    if (!reachable) continue;
    EXPECT_EQ(relaxed.length() == 0, problem.goals.subset_of(problem.initials)) << seed;
    EXPECT_EQ(relaxed.length() == 0, relaxed.helpful().empty()) << seed;
    for (const ActionIndex action : relaxed.helpful()) {
      EXPECT_TRUE(compact.applicable(action, problem.initials)) << seed;
    }
  }
}

TEST(FastPlanner, FindsTheFewestActionsForTwentyBlocksAndProvesIt) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const Problem problem = ground(random_blocks(20, random)).value();
    const std::size_t fewest = OptimalPlanner().solve(problem, {}, never).steps.size();
    const Outcome outcome = FastPlanner().solve(problem, effort(300'000), never);
    EXPECT_EQ(actions_of(outcome), fewest) << seed;
    EXPECT_TRUE(outcome.shortest) << seed;
  }
}

TEST(FastPlanner, HasNothingToDoWhereTheGoalsHold) {
  PlanningTask task = blocks_domain(2);
  task.initials = facts_of("(on-table b0) (clear b0) (on-table b1) (clear b1) (arm-empty)");
  task.goals = facts_of("(on-table b0)");
  const Outcome outcome = FastPlanner().solve(ground(task).value(), Budget{}, never);
  EXPECT_EQ(outcome.kind, Outcome::Kind::plan);
  EXPECT_TRUE(outcome.steps.empty());
}

TEST(FastPlanner, ShortensAPlanBeforeItTriesToProveItTheShortest) {
  std::size_t first = 0;
  std::size_t shortened = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    Random random(seed);
    const Problem problem = ground(random_blocks(30, random)).value();
    std::size_t length = 0, looks = 0;
    const auto better = [&](const Outcome& plan) {
      if (length == 0) length = actions_of(plan);
    };
    // Sooner than the proof can be ready.
    const auto cancelled = [&] { return length > 0 && ++looks > 4 * length; };
    const Outcome outcome = FastPlanner({.better = better}).solve(problem, Budget{}, cancelled);
    EXPECT_FALSE(outcome.shortest) << "seed " << seed;
    first += length;
    shortened += actions_of(outcome);
  }
  EXPECT_LT(shortened, first);
}

// The longest time of the processor between two looks at whether it is cancelled, until this many of them.
std::clock_t longest_silence(const Problem& problem, std::size_t looks) {
  std::clock_t before = std::clock(), longest = 0;
  const auto cancelled = [&] {
    const std::clock_t now = std::clock();
    longest = std::max(longest, now - std::exchange(before, now));
    return looks == 0 || --looks == 0;
  };
  EXPECT_EQ(FastPlanner().solve(problem, Budget{}, cancelled).kind, Outcome::Kind::cancelled);
  return longest;
}

TEST(FastPlanner, HearsOfItsCancellationWhileItLearnsTheProblem) {
  Random random(8);
  const Problem problem = ground(random_blocks(200, random)).value();
  const std::clock_t begin = std::clock();
  EXPECT_TRUE(Nearness(problem).estimate.here());
  const std::clock_t learning = std::clock() - begin;
  EXPECT_LT(2 * longest_silence(problem, 100), learning);
}

TEST(FastPlanner, CanBeCancelledWhereverItIs) {
  Random random(9);
  const Problem problem = ground(random_blocks(30, random)).value();
  for (std::size_t looks = 1; looks < 60; ++looks) longest_silence(problem, looks);
}

TEST(InvariantGroups, NeverHoldTogetherOnAnyWay) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const PlanningTask task = random_task(seed);
    const Problem problem = ground(task).value();
    const CompactProblem compact(problem);
    const InvariantGroups invariants(problem, compact);
    Random random(seed);
    Bits state = problem.initials;
    for (int step = 0; step < 60; ++step) {
      for (const std::vector<FactIndex>& group : invariants.groups()) {
        ASSERT_LE(std::ranges::count_if(group, [&](FactIndex fact) { return state.test(fact); }), 1)
            << seed << " " << show(task);
      }
      std::vector<ActionIndex> applicable;
      compact.for_each_applicable(state, [&](ActionIndex action) { applicable.push_back(action); });
      if (applicable.empty()) break;
      compact.apply(applicable[random.below(applicable.size())], state);
    }
  }
}

TEST(InvariantGroups, SayThatABlockIsInOnePlaceWithOneThingOnIt) {
  Random random(1);
  const Problem problem = ground(random_blocks(3, random)).value();
  const InvariantGroups invariants(problem, CompactProblem(problem));
  const auto fact = [&](std::string_view text) {
    return static_cast<FactIndex>(std::ranges::find(problem.facts, form(text)) - problem.facts.begin());
  };
  EXPECT_TRUE(invariants.exclude(fact("(on b0 b1)"), fact("(on b0 b2)")));
  EXPECT_TRUE(invariants.exclude(fact("(on b0 b1)"), fact("(on b2 b1)")));
  EXPECT_TRUE(invariants.exclude(fact("(on b0 b1)"), fact("(holding b0)")));
  EXPECT_TRUE(invariants.exclude(fact("(holding b0)"), fact("(holding b1)")));
  EXPECT_FALSE(invariants.exclude(fact("(on b0 b1)"), fact("(on b1 b2)")));
}

TEST(FastPlanner, KeepsItsBestPlanWhereMemoryEnds) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const PlanningTask task = random_blocks(6, random);
    const Problem problem = ground(task).value();
    bool found = false;
    FastPlanner engine({.better = [&](const Outcome&) { found = true; }});
    const Outcome best = engine.solve(problem, effort(100'000), [&] {
      if (found) throw std::bad_alloc();
      return false;
    });
    ASSERT_EQ(best.kind, Outcome::Kind::plan);
    EXPECT_TRUE(validate_plan(task, steps_of(problem, best.steps))) << show(task);
    EXPECT_EQ(best.out_of_memory, !best.shortest);
  }
}

TEST(PlanReordering, KeepsThePlanWorkingAndNeverMakesItLonger) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    SCOPED_TRACE(seed);
    const PlanningTask task = random_task(seed);
    const Problem problem = ground(task).value();
    const Outcome first = FastPlanner({.seed = seed, .first_only = true}).solve(problem, effort(2000), never);
    if (first.kind != Outcome::Kind::plan) continue;
    std::vector<ActionIndex> plan;
    for (const std::vector<std::size_t>& step : first.steps) plan.insert(plan.end(), step.begin(), step.end());
    const CompactProblem compact(problem);
    Random random(seed);
    PlanReordering reordering(compact, plan, random);
    std::size_t length = plan.size();
    for (int attempt = 0; attempt < 100; ++attempt) {
      const bool shorter = reordering.try_once();
      EXPECT_EQ(shorter, reordering.plan().size() < length);
      length = std::min(length, reordering.plan().size());
      Bits state = problem.initials;
      for (const ActionIndex action : reordering.plan()) {
        ASSERT_TRUE(compact.applicable(action, state)) << show(task);
        compact.apply(action, state);
      }
      ASSERT_TRUE(problem.goals.subset_of(state)) << show(task);
    }
  }
}

TEST(IdleActions, AreLeftOutWithTheStepsTheyWereAloneIn) {
  PlanningTask task = blocks_domain(2);
  task.initials = facts_of("(on-table b0) (clear b0) (on-table b1) (clear b1) (arm-empty)");
  task.goals = facts_of("(on b0 b1)");
  const Problem problem = ground(task).value();
  const auto action = [&](std::string_view text) {
    return static_cast<std::size_t>(std::ranges::find(problem.actions, form(text), &GroundAction::name) -
                                    problem.actions.begin());
  };
  const std::size_t pick = action("(PICK-UP b0)"), put = action("(PUT-DOWN b0)"), stack = action("(STACK b0 b1)");
  ASSERT_LT(std::max({pick, put, stack}), problem.actions.size());
  EXPECT_EQ(without_idle_actions(problem, {{pick}, {put}, {pick}, {stack}}),
            (std::vector<std::vector<std::size_t>>{{pick}, {stack}}));
}

}  // namespace
}  // namespace pizarra::planner
