#pragma once

// Compares the facts on the board with what was said to be kept: marks that the board acknowledged as durable, the goal
// whose state the coordinator tells, and the plan that the planner tells of.
//
//   KeptObserver observer(cell, [&](std::string sentence) { ... });
//   observer.acknowledged(7);                 // the board said that it keeps (chaos-mark 7)
//   observer.look();                          // again and again
//   observer.check_marks();                   // when the board lives again, and at the end

#include <cstdint>
#include <functional>
#include <set>
#include <string>

#include "programs/chaos/chaos_cell.hpp"

namespace pizarra::chaos {

class KeptObserver {
 public:
  using Unsafe = std::function<void(std::string sentence)>;

  // The cell outlives it.
  KeptObserver(ChaosCell& cell, Unsafe unsafe) : cell_(cell), unsafe_(std::move(unsafe)) {}

  void acknowledged(std::int64_t mark) { marks_.insert(mark); }
  void check_marks() const;
  void look();

 private:
  void look_at_goals();
  void look_at_plan();

  ChaosCell& cell_;
  const Unsafe unsafe_;
  std::set<std::int64_t> marks_;
  std::set<std::int64_t> goals_not_kept_;
  bool disk_failed_ = false;  // at some time of this run
  bool plan_is_kept_ = true;
};

}  // namespace pizarra::chaos
