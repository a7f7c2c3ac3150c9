#pragma once

// How far a state is from the goals: the number of things that have to happen on the way, whichever way is taken.
//
//   LandmarkEstimate estimate(problem, invariants);
//   estimate.look_at(state);
//   const std::optional<Distance> distance = estimate.beyond(action);      // of the state that the action leads to
//
// A goal that does not hold must be made true. Facts that every action needs which makes it true must be made true
// before. A fact that holds and excludes one of these must be taken away; then facts that every action needs or makes
// true which takes it away are unavoidable too. A goal that must be taken away must be made true again. These are
// landmarks of the state itself, found by local reasoning (compare Hoffmann, Porteous and Sebastia 2004), and no memory
// of the way is needed. Facts that one and the same action makes true count once.

#include <optional>

#include "agents/planner/distance/invariant_groups.hpp"

namespace pizarra::planner {

// Sorts states: smaller is nearer.
using Distance = std::uint32_t;

class LandmarkEstimate {
 public:
  // Not to be asked where this was cancelled.
  LandmarkEstimate(
      const CompactProblem& problem, const InvariantGroups& invariants,
      const std::function<bool()>& cancelled = [] { return false; });

  void look_at(const Bits& state);
  // Of the state looked at, and of one action beyond it. None: the goals cannot be reached from there.
  std::optional<Distance> here();
  std::optional<Distance> beyond(ActionIndex action);

 private:
  // False when they were cancelled.
  bool learn_changes(const std::function<bool()>& cancelled);
  bool learn_hops(const std::function<bool()>& cancelled);
  std::vector<std::uint32_t> hops_to(FactIndex goal, std::span<const FactIndex> group) const;
  void set(FactIndex fact);
  void reset(FactIndex fact);
  std::uint32_t hops_left(std::size_t goal) const;
  void push(FactIndex fact);
  bool must_happen(FactIndex fact);
  bool must_be_taken_away(FactIndex fact);
  bool makes_room(FactIndex in_the_way, FactIndex fact) const;
  void count_once(FactIndex event);
  bool ready(FactIndex goal) const;

  // Where in items_ the rows of a fact begin, one behind the other.
  struct Rows {
    std::uint32_t groups;        // that it is in
    std::uint32_t ranks;         // its place in each of them
    std::uint32_t needs;         // what all actions need that add it
    std::uint32_t leaving_adds;  // what all actions add that delete it
    std::uint32_t leaving;       // what else they all need
    std::uint32_t end;
    bool can_come, can_go, is_goal;
  };
  std::span<const std::uint32_t> row(std::uint32_t begin, std::uint32_t end) const {
    return {items_.data() + begin, end - begin};
  }
  std::span<const std::uint32_t> groups_of(FactIndex fact) const { return row(rows_[fact].groups, rows_[fact].ranks); }

  const CompactProblem& problem_;
  const InvariantGroups& invariants_;
  std::vector<Rows> rows_;
  std::vector<std::uint32_t> items_;
  std::vector<FactIndex> goals_;
  // Of a goal, for one of its groups: from a fact of that, by its rank in the group, so many hops.
  struct Hops {
    std::uint32_t group;
    std::uint32_t from;  // in hops_
  };
  std::vector<std::vector<Hops>> hops_of_;
  std::vector<std::uint32_t> hops_;

  Bits state_;
  struct Holds {
    FactIndex fact;
    std::uint32_t rank;  // its place in the group
  };
  std::vector<Holds> holds_;                // of a group: which of its facts holds
  std::vector<FactIndex> added_, deleted_;  // by the action beyond

  // One evaluation: marks are of this one where they equal its number.
  std::uint32_t evaluation_ = 0;
  struct Marks {
    std::uint32_t pending = 0, taken = 0, counted = 0;
    bool holds = false;  // of the state
  };
  std::vector<Marks> marks_;  // of a fact
  std::vector<std::uint32_t> goal_hops_;
  struct Awaited {
    std::uint32_t count = 0, in = 0;  // of which evaluation the count is
  };
  std::vector<Awaited> awaited_;  // of a group: how many of its facts are pending
  std::vector<FactIndex> open_;
  std::uint32_t events_ = 0;
  std::uint32_t facts_ = 0;
};

}  // namespace pizarra::planner
