#pragma once

// Plans for one task after another, and quickly where only the initial facts have changed since the last. It keeps the
// grounded problem and what was learned of it. A state that the last plan comes through needs no new plan. A plan made
// fast is kept wherever an end of it works, and repaired where a few actions lead back to it.
//
//   Replanner replanner;
//   Result<ReadyPlan> plan = replanner.plan(task, Budget{}, cancelled);
//   task.initials = what_is_seen_now;
//   plan = replanner.plan(task, Budget{}, cancelled);
//
// Kept or new, a plan is a shortest one. Where the problem is too large for that, or the budget does not suffice, it is
// some plan made fast. A kept plan is never used for other goals, objects or operators.
// The same tasks in the same order get the same plans.

#include <map>
#include <optional>

#include "agents/planner/fast/fast_planner.hpp"
#include "agents/planner/fast/last_plan.hpp"
#include "agents/planner/optimal/optimal_search.hpp"

namespace pizarra::planner {

struct ReadyPlan {
  PlanSteps steps;
  PlanMode mode = PlanMode::optimal;  // optimal: no plan has fewer parallel steps
  std::string_view engine;  // `kept`: the end of the last plan; `repaired`: with a way back to it; else the search
  std::size_t nodes = 0;    // work done
};

class Replanner {
 public:
  // The failures of ground(), explain() and validate_plan(). One that is cancelled forgets nothing of the task.
  Result<ReadyPlan> plan(const PlanningTask& task, const Budget& budget, const std::function<bool()>& cancelled);

 private:
  // The grounded problem of a task, and all that is known of it.
  struct Known {
    explicit Known(const PlanningTask& for_task, Problem grounded);
    PlanningTask task;
    Problem problem;
    std::optional<OptimalSearch> search;  // none: the problem is too large
    std::optional<Nearness> nearness;     // for plans made fast, when first needed
    // Of the facts, as far as the problem goes: those that can hold, and those that held at first and cannot end.
    Bits possible, lasting;
    std::map<Datum, std::size_t> fact_index;
    std::vector<Datum> fixed;  // initial facts that are not among the problem's
    std::optional<LastPlan> last;
  };
  bool begin_from(const std::vector<Datum>& initials);
  // A plan, and of which mode it is.
  struct Found {
    Outcome outcome;
    PlanMode mode = PlanMode::optimal;
  };
  std::optional<Found> rest_of_last_plan() const;
  Found search(const Budget& budget, const std::function<bool()>& cancelled);
  Outcome search_fast(const Budget& budget, const std::function<bool()>& cancelled);

  std::unique_ptr<Known> known_;
};

}  // namespace pizarra::planner
