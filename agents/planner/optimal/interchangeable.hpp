#pragma once

// Objects that are alike: exchanging two of them changes neither the initial facts, nor the goals, nor what can be
// done. The balls of a robot that carries balls from one room to another are.
//
//   const Interchangeable alike(problem);
//   alike.sort(state);         // the same for all states that differ by which of the alike objects is which
//
// Only objects no two of which share a fact are seen, and the order found is not always unique where objects of several
// kinds share facts: then fewer states are taken for the same, never more.

#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

class Interchangeable {
 public:
  explicit Interchangeable(const Problem& problem);

  bool any() const { return !kinds_.empty(); }
  void sort(Bits& state) const;

 private:
  // One kind of objects: for every object its facts, in the same order for all.
  using Kind = std::vector<std::vector<std::size_t>>;
  std::vector<Kind> kinds_;
};

}  // namespace pizarra::planner
