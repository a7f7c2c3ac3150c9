#include "agents/planner/task/idle_actions.hpp"

namespace pizarra::planner {

namespace {

struct Placed {
  std::size_t action;
  std::size_t step;
};

// Behind `begin`, where a step begins in that state: what is left without the action at `left_out` and all that cannot
// be done without it. Whether it still reaches the goals.
bool reaches_goals(const Problem& problem, const std::vector<Placed>& plan, std::size_t begin, std::size_t left_out,
                   Bits state, std::vector<Placed>& rest) {
  rest.clear();
  for (std::size_t i = begin; i < plan.size();) {
    const std::size_t step = plan[i].step;
    std::size_t done = rest.size();
    for (; i < plan.size() && plan[i].step == step; ++i) {
      if (i != left_out && applicable(problem.actions[plan[i].action], state)) rest.push_back(plan[i]);
    }
    for (; done < rest.size(); ++done) apply(problem.actions[rest[done].action], state);
  }
  return problem.goals.subset_of(state);
}

std::vector<Placed> placed(const std::vector<std::vector<std::size_t>>& steps) {
  std::vector<Placed> plan;
  for (std::size_t step = 0; step < steps.size(); ++step) {
    for (const std::size_t action : steps[step]) plan.push_back({action, step});
  }
  return plan;
}

std::vector<std::vector<std::size_t>> grouped(const std::vector<Placed>& plan) {
  std::vector<std::vector<std::size_t>> steps;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (i == 0 || plan[i].step != plan[i - 1].step) steps.emplace_back();
    steps.back().push_back(plan[i].action);
  }
  return steps;
}

}  // namespace

std::vector<std::vector<std::size_t>> without_idle_actions(const Problem& problem,
                                                           const std::vector<std::vector<std::size_t>>& steps) {
  std::vector<Placed> plan = placed(steps);
  std::vector<Placed> rest;
  Bits state = problem.initials;
  for (std::size_t begin = 0; begin < plan.size();) {
    const std::size_t step = plan[begin].step;
    std::size_t end = begin;
    while (end < plan.size() && plan[end].step == step) {
      if (!reaches_goals(problem, plan, begin, end, state, rest)) {
        ++end;
        continue;
      }
      plan.resize(begin);
      plan.insert(plan.end(), rest.begin(), rest.end());
    }
    for (; begin < end; ++begin) apply(problem.actions[plan[begin].action], state);
  }
  return grouped(plan);
}

}  // namespace pizarra::planner
