#pragma once

// Standing facts in the order of their ids, each in a place of its own that does not move: found by id in logarithmic
// time, put at the end and taken out at once, without an allocation for each.
//
//   FactList facts;
//   StandingFact& standing = facts.insert({fact});
//   for (const StandingFact& standing : facts.from(first_id)) ...
//   Fact former = facts.replace(standing, fact);          // in the former's memory, at the end of the order
//   StandingFact gone = facts.remove(standing);
//
// A removed fact leaves its mark in the order; the marks are swept away when there are more of them than facts. Those
// before the first fact are never gone through, so that taking from the front costs the same however many have gone
// from there.

#include <algorithm>
#include <deque>
#include <optional>
#include <ranges>
#include <span>
#include <vector>

#include "blackboard/fact.hpp"

namespace pizarra::store {

class FactTable;

// Two lines of a cache, fetched at once, and no third.
struct alignas(128) StandingFact {
  Fact fact;
  LeaseId lease = 0;
  std::optional<Time> expiry = {};  // by the relation's own lease
  FactTable* table = nullptr;       // where it stands
};
static_assert(sizeof(StandingFact) == 128);

class FactList {
  struct Place {
    FactId id;
    StandingFact* standing;
    // Where the fact is gone, another has its memory, or none.
    bool stands() const { return standing->fact.id == id; }
  };
  template <class Order>
  static auto lower_bound(Order& order, FactId id) {
    return std::ranges::lower_bound(order, id, {}, &Place::id);
  }

 public:
  FactList() = default;
  FactList(const FactList&) = delete;
  FactList& operator=(const FactList&) = delete;

  std::size_t size() const { return order_.size() - gone_; }
  StandingFact* find(FactId id);
  // None that stands has a higher id.
  FactId newest() const { return order_.empty() ? 0 : order_.back().id; }
  // None with its id may stand. Quick where its id is the highest so far.
  StandingFact& insert(StandingFact standing);
  // By a fact whose id is the highest so far; answers the former.
  Fact replace(StandingFact& standing, Fact fact);
  StandingFact remove(StandingFact& standing);
  // Those with an id from `first` on.
  auto from(FactId first) const {
    const std::span living(order_.begin() + static_cast<std::ptrdiff_t>(first_), order_.end());
    return std::span(lower_bound(living, first), living.end()) | std::views::filter(&Place::stands) |
           std::views::transform([](const Place& place) -> const StandingFact& { return *place.standing; });
  }

 private:
  StandingFact& memory_for(StandingFact standing);
  void leave_mark();
  void sweep();

  std::vector<Place> order_;
  std::size_t gone_ = 0;   // of the order
  std::size_t first_ = 0;  // of the order that is not gone
  std::deque<StandingFact> memory_;
  std::vector<StandingFact*> free_;
};

}  // namespace pizarra::store
