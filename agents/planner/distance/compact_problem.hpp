#pragma once

// A grounded problem laid out for searches that look at very many states: facts and actions are 32-bit numbers, and
// what belongs to one action, or to one fact, stands in one row.
//
//   const CompactProblem compact(problem);
//   compact.for_each_applicable(state, [&](Action action) { ... compact.apply(action, state) ... });
//
// Numbers are those of the problem.

#include "agents/planner/task/problem.hpp"
#include "agents/planner/task/rows.hpp"

namespace pizarra::planner {

using FactIndex = std::uint32_t;
using ActionIndex = std::uint32_t;

class CompactProblem {
 public:
  explicit CompactProblem(const Problem& problem);

  std::size_t facts() const { return facts_; }
  std::size_t actions() const { return preconditions_.size(); }
  std::span<const FactIndex> preconditions(ActionIndex action) const { return preconditions_[action]; }
  std::span<const FactIndex> adds(ActionIndex action) const { return adds_[action]; }
  std::span<const FactIndex> deletes(ActionIndex action) const { return deletes_[action]; }
  std::span<const ActionIndex> needing(FactIndex fact) const { return needing_[fact]; }
  std::span<const ActionIndex> adding(FactIndex fact) const { return adding_[fact]; }
  std::span<const ActionIndex> deleting(FactIndex fact) const { return deleting_[fact]; }
  const Bits& initials() const { return initials_; }
  void begin_from(const Bits& initials) { initials_ = initials; }
  const Bits& goals() const { return goals_; }

  bool applicable(ActionIndex action, const Bits& state) const {
    for (const FactIndex fact : preconditions_[action]) {
      if (!state.test(fact)) return false;
    }
    return true;
  }
  void apply(ActionIndex action, Bits& state) const {
    for (const FactIndex fact : deletes_[action]) state.reset(fact);
    for (const FactIndex fact : adds_[action]) state.set(fact);
  }

  // Every action is looked at only where the rarest of its preconditions holds.
  template <class Visit>
  void for_each_applicable(const Bits& state, Visit visit) const {
    for (const ActionIndex action : keyless_) visit(action);
    state.for_each([&](std::size_t fact) {
      for (const ActionIndex action : keyed_[fact]) {
        if (applicable(action, state)) visit(action);
      }
    });
  }

 private:
  std::size_t facts_;
  Rows preconditions_, adds_, deletes_, needing_, adding_, deleting_;
  Rows keyed_;                        // of a fact: the actions it is the rarest precondition of
  std::vector<ActionIndex> keyless_;  // those without preconditions
  Bits initials_, goals_;
};

}  // namespace pizarra::planner
