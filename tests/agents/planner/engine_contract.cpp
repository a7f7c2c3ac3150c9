#include "tests/agents/planner/engine_contract.hpp"

#include "agents/planner/task/grounding.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

PlanningTask blamed(const PlanningTask& task, const Problem& problem, const std::vector<std::size_t>& culprits) {
  PlanningTask blamed = task;
  blamed.goals.clear();
  blamed.absent_goals.clear();
  for (const std::size_t index : culprits) {
    const Datum& fact = problem.facts[index];
    if (fact.is_form("not")) {
      blamed.absent_goals.push_back(fact[1]);
    } else {
      blamed.goals.push_back(fact);
    }
  }
  return blamed;
}

void expect_fewest_steps(PlanEngine& engine, const PlanningTask& task) {
  const std::optional<std::size_t> fewest = fewest_steps(task);
  const Result<Problem> problem = ground(task);
  ASSERT_TRUE(problem) << problem.error().sentence;
  const Outcome outcome = engine.solve(*problem, {}, never);
  if (fewest) {
    ASSERT_EQ(outcome.kind, Outcome::Kind::plan) << outcome.engine << ' ' << outcome.spent;
    EXPECT_EQ(outcome.steps.size(), *fewest);
    const Result<void> valid = validate_plan(task, steps_of(*problem, outcome.steps));
    EXPECT_TRUE(valid) << valid.error().sentence;
    return;
  }
  ASSERT_EQ(outcome.kind, Outcome::Kind::none) << outcome.engine << ' ' << outcome.spent;
  EXPECT_FALSE(outcome.culprits.empty());
  for (const std::size_t culprit : outcome.culprits) EXPECT_TRUE(problem->goals.test(culprit));
  const PlanningTask rest = blamed(task, *problem, outcome.culprits);
  EXPECT_FALSE(fewest_steps(rest)) << "these can be reached together: " << show(rest);
}

void expect_no_idle_action(PlanEngine& engine, const PlanningTask& task) {
  const Problem problem = ground(task).value();
  const Outcome outcome = engine.solve(problem, {}, never);
  std::vector<std::size_t> plan;
  for (const std::vector<std::size_t>& step : outcome.steps) plan.insert(plan.end(), step.begin(), step.end());
  for (std::size_t left_out = 0; left_out < plan.size(); ++left_out) {
    Bits state = problem.initials;
    for (std::size_t i = 0; i < plan.size(); ++i) {
      const GroundAction& action = problem.actions[plan[i]];
      if (i != left_out && applicable(action, state)) state = after(state, action);
    }
    EXPECT_FALSE(problem.goals.subset_of(state)) << write(problem.actions[plan[left_out]].name) << " is idle";
  }
}

PlanningTask random_impossible_blocks(Random& random) {
  PlanningTask task = random_blocks(3, random);
  task.goals.clear();
  const std::vector<Datum> names = facts_of("b0 b1 b2");
  for (std::size_t i = 0; i < 3; ++i) {
    task.goals.push_back(list("on"_sym, names[random.below(3)], names[random.below(3)]));
  }
  if (random.below(2) == 0) task.goals.push_back(list("holding"_sym, names[random.below(3)]));
  return task;
}

}  // namespace pizarra::planner
