#pragma once

// How many of several visits must be repeated, given which first and last visits come before which others. A visit made
// once is its first and its last, so orders that form a cycle need a repeated visit on it.
//
//   VisitOrder order(2);
//   order.first_before_first(0, 1);
//   order.last_before_last(0, 1);
//   order.fewest_repeats();               // 0
//   order.first_before_last(1, 0);        // after which 0 is first, then 1, then 0 again
//   order.fewest_repeats();               // 1

#include <vector>

#include "agents/planner/task/bits.hpp"

namespace pizarra::planner {

class VisitOrder {
 public:
  explicit VisitOrder(std::size_t visits);

  void first_before_first(std::size_t earlier, std::size_t later) { after_[earlier].set(later); }
  void first_before_last(std::size_t earlier, std::size_t later) { after_[earlier].set(count_ + later); }
  void last_before_last(std::size_t earlier, std::size_t later) { after_[count_ + earlier].set(count_ + later); }

  // A lower bound, and the least number but for hard cases.
  std::size_t fewest_repeats() const;

 private:
  using Visits = std::vector<std::size_t>;
  Visits cycle_through(std::size_t visit, const Bits& repeated) const;

  std::size_t count_;
  std::vector<Bits> after_;  // of every first time, then of every last time
};

// The fewest elements that hit all the sets, or, when that takes more than a set number of steps to find, fewer.
struct Hitting {
  std::vector<std::size_t> elements;
  bool complete = true;  // whether they do hit all sets
  std::size_t at_least = 0;
};
Hitting fewest_hitting(const std::vector<std::vector<std::size_t>>& sets, std::size_t at_least);

}  // namespace pizarra::planner
