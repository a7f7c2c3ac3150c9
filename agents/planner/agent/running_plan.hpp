#pragma once

// A plan that is being carried out: the triangle table of its operations. For each end of the plan it holds the facts
// that must hold for that end to reach the goals. The last end is empty and needs the goals themselves.
// A need is a fact that must hold, or (not FACT) of one that must not.
//
// The next operation follows from the facts that hold: the furthest end whose needs hold. That skips what somebody else
// did, and repeats what was undone while the plan covers it.
//
//   RunningPlan plan(7, operations, operators, goals);
//   std::optional<std::size_t> next = plan.next(what_holds);    // the operation's index; size(): done; none: plan anew

#include <optional>
#include <set>

#include "agents/planner/task/planning_task.hpp"
#include "lisp/result.hpp"

namespace pizarra::planner {

class RunningPlan {
 public:
  using Facts = std::set<Datum>;

  // The operations are those of a plan that was found with these operators.
  RunningPlan(std::int64_t number, std::vector<Datum> operations, const std::vector<PlanningOperator>& operators,
              const std::vector<Datum>& goals);
  // The inverse of facts(). Failure bad-plan.
  static Result<RunningPlan> from_facts(const Datum& plan, const Datum& needs);

  // (plan NUMBER (OPERATION ...)) and (plan-needs NUMBER ((FACT ...) ...)), one list more than operations.
  std::vector<Datum> facts() const;
  std::int64_t number() const { return number_; }
  const std::vector<Datum>& operations() const { return operations_; }
  std::optional<std::size_t> next(const Facts& holding) const;
  // (INDEX (OPERATION ...) (FACT ...) (FACT ...)): the operation at the index and those after it, what must hold before
  // it, and after it; of the empty end, the goals both times.
  Datum from(std::size_t index) const;

 private:
  RunningPlan() = default;

  std::int64_t number_ = 0;
  std::vector<Datum> operations_;
  std::vector<Facts> needs_;
};

}  // namespace pizarra::planner
