#pragma once

// Whether the planner has a plan of the goal in hand, and the operation to go on with.
//
//   PlanInHand plan(planning, story);
//   co_await plan.tell(goal, operations);                                // one was made
//   Result<std::optional<NextOperation>> next = co_await plan.next(goal);      // none where it does not serve

#include <optional>
#include <vector>

#include "agents/coordinator/pursue/planning.hpp"

namespace pizarra::coordinator {

class PlanInHand {
 public:
  PlanInHand(Planning& planning, Story& story) : planning_(planning), story_(story) {}

  Task<Result<std::optional<NextOperation>>> next(std::int64_t goal);
  Task<void> tell(std::int64_t goal, std::vector<Datum> operations);
  // All objects of the goal had been found then.
  bool was_made_for(std::int64_t goal) const { return goal == goal_; }
  // One that an earlier life of the coordinator had made.
  void take_up(std::int64_t goal) { goal_ = goal; }
  void forget() { goal_ = 0; }

 private:
  Planning& planning_;
  Story& story_;
  std::int64_t goal_ = 0;  // for which the planner may have a plan
};

}  // namespace pizarra::coordinator
