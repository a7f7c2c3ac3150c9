#pragma once

// The landmarks that every plan passes if nothing were ever deleted: of some disjoint kinds of actions, those of which
// a fact needs one before it can hold (Zhu & Givan, "Landmark extraction via planning graph propagation", 2003). One
// propagation finds it for all kinds at once.
//
//   RelaxedLandmarks landmarks(problem, allowed, kind_of, kinds);
//   landmarks.from(state);
//   landmarks.of_fact(fact).test(2);        // no way to the fact without an action of kind 2
//
// A fact that cannot be reached at all needs every kind.

#include <cstdint>
#include <vector>

#include "agents/planner/task/problem.hpp"
#include "agents/planner/task/rows.hpp"

namespace pizarra::planner {

class RelaxedLandmarks {
 public:
  static constexpr std::uint32_t no_kind = UINT32_MAX;

  // `kind_of` has a number below `kinds` for every action, or no_kind. The problem outlives it.
  RelaxedLandmarks(const Problem& problem, const Bits& allowed, std::vector<std::uint32_t> kind_of, std::size_t kinds);

  void from(const Bits& state);
  bool reached(std::size_t fact) const { return reached_[fact] != 0; }
  Bits of_fact(std::size_t fact) const;
  // The kinds that all the actions need, their own kinds included; every kind where there is no action.
  Bits of_all(const std::vector<std::uint32_t>& actions) const;

 private:
  using Word = std::uint64_t;
  bool label(std::size_t action, Word* to) const;
  void reach(std::size_t fact, const Word* needed);

  const Problem& problem_;
  const std::vector<std::uint32_t> kind_of_;
  const std::size_t kinds_, words_;
  Rows needs_, adds_;  // of every action
  Rows needed_by_;     // of every fact: allowed actions
  std::vector<std::uint32_t> need_count_, needless_;

  std::vector<std::uint32_t> missing_;
  std::vector<Word> labels_;         // of every fact
  std::vector<char> reached_;        // of every fact
  std::vector<char> waiting_;        // of every action: whether it is open
  std::vector<std::uint32_t> open_;  // actions whose needs have changed; first in, first out
  std::vector<Word> scratch_;
};

}  // namespace pizarra::planner
