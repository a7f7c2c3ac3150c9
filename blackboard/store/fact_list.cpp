#include "blackboard/store/fact_list.hpp"

#include <cassert>
#include <utility>

namespace pizarra::store {

StandingFact* FactList::find(FactId id) {
  if (order_.empty() || order_.back().id < id) return nullptr;
  const auto found = lower_bound(order_, id);
  return found->id == id && found->stands() ? found->standing : nullptr;
}

StandingFact& FactList::insert(StandingFact standing) {
  const FactId id = standing.fact.id;
  assert(id != 0);
  StandingFact& kept = memory_for(std::move(standing));
  if (order_.empty() || order_.back().id < id) {
    order_.push_back({id, &kept});
    return kept;
  }
  const auto place = lower_bound(order_, id);
  first_ = std::min(first_, static_cast<std::size_t>(place - order_.begin()));
  if (place->id != id) {
    order_.insert(place, {id, &kept});
    return kept;
  }
  assert(!place->stands() || place->standing == &kept);
  place->standing = &kept;
  --gone_;
  return kept;
}

Fact FactList::replace(StandingFact& standing, Fact fact) {
  assert(order_.back().id < fact.id);
  order_.push_back({fact.id, &standing});
  Fact former = std::exchange(standing.fact, std::move(fact));
  leave_mark();
  return former;
}

StandingFact FactList::remove(StandingFact& standing) {
  StandingFact removed = std::exchange(standing, {});
  free_.push_back(&standing);
  leave_mark();
  return removed;
}

void FactList::leave_mark() {
  ++gone_;
  while (first_ < order_.size() && !order_[first_].stands()) ++first_;
  sweep();
}

StandingFact& FactList::memory_for(StandingFact standing) {
  if (free_.empty()) return memory_.emplace_back(std::move(standing));
  StandingFact& memory = *free_.back();
  free_.pop_back();
  return memory = std::move(standing);
}

void FactList::sweep() {
  constexpr std::size_t few = 64;
  if (gone_ <= size() + few) return;
  std::erase_if(order_, [](const Place& place) { return !place.stands(); });
  gone_ = 0;
  first_ = 0;
  if (!order_.empty()) return;
  free_.clear();
  memory_.clear();
}

}  // namespace pizarra::store
