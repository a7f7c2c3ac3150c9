#pragma once

// Plans for goals that can be had in several ways (lisp/forms/goal_formula.hpp): each way is planned for, and the
// shortest plan taken. That no plan exists is proved of every way.
//
//   Result<ShortestWay> found = plan_shortest_way(replanner, task, {(or (on a b) (on-table a))}, Budget{}, cancelled);
//   found->literals;         // what the plan leads to: (on-table a)

#include "agents/planner/agent/replanner.hpp"
#include "lisp/forms/goal_formula.hpp"

namespace pizarra::planner {

struct ShortestWay {
  ReadyPlan plan;
  forms::GoalLiterals literals;
};

// The task has no goals of its own. Failures: those of Replanner::plan(), too-many. A goal that contradicts itself is
// proved to have no plan.
Result<ShortestWay> plan_shortest_way(Replanner& replanner, PlanningTask task, const std::vector<Datum>& goals,
                                      const Budget& budget, const std::function<bool()>& cancelled);

}  // namespace pizarra::planner
