#include "blackboard/fact_table.hpp"

#include <algorithm>
#include <bit>
#include <cassert>

#include "lisp/pattern.hpp"

namespace pizarra {

namespace {

constexpr std::size_t small_enough_to_look_through = 16;
const std::set<FactId> no_facts;

}  // namespace

FactTable::Entry* FactTable::find(FactId id) {
  const auto found = entries_.find(id);
  return found == entries_.end() ? nullptr : &found->second;
}

FactTable::Entry* FactTable::find_key_of(const Datum& fact) {
  const auto found = by_key_.find(key_of(relation_, fact));
  return found == by_key_.end() ? nullptr : find(found->second);
}

FactTable::Entry& FactTable::insert(Entry entry) {
  const FactId id = entry.fact.id;
  const Datum& datum = entry.fact.datum;
  [[maybe_unused]] const bool key_free = by_key_.emplace(key_of(relation_, datum), id).second;
  assert(key_free);
  for (auto& [mask, index] : indexes_) index[arguments_in(mask, datum)].insert(id);
  const auto [place, id_free] = entries_.emplace(id, std::move(entry));
  assert(id_free);
  return place->second;
}

FactTable::Entry FactTable::remove(FactId id, Revision revision) {
  const auto found = entries_.find(id);
  assert(found != entries_.end());
  Entry entry = std::move(found->second);
  entries_.erase(found);
  const Datum& datum = entry.fact.datum;
  by_key_.erase(key_of(relation_, datum));
  for (auto& [mask, index] : indexes_) {
    const auto place = index.find(arguments_in(mask, datum));
    place->second.erase(id);
    if (place->second.empty()) index.erase(place);
  }
  removals_.push_back({revision, datum});
  if (removals_.size() > max_removals) {
    removals_forgotten_ = removals_.front().revision;
    removals_.pop_front();
  }
  return entry;
}

void FactTable::visit(const Datum& pattern, const Visitor& visitor) const {
  const bool key_bound = std::all_of(relation_.key.begin(), relation_.key.end(),
                                     [&](std::size_t position) { return is_ground(pattern[position + 1]); });
  if (key_bound) {
    const auto found = by_key_.find(key_of(relation_, pattern));
    if (found != by_key_.end()) visitor(entries_.at(found->second).fact);
    return;
  }
  if (const std::set<FactId>* ids = bucket(pattern)) {
    for (const FactId id : *ids) {
      if (!visitor(entries_.at(id).fact)) return;
    }
    return;
  }
  for (const auto& [id, entry] : entries_) {
    if (!visitor(entry.fact)) return;
  }
}

bool FactTable::unchanged_since(const Datum& pattern, Revision revision) const {
  if (revision < removals_forgotten_) return false;
  const auto fits = [&](const Datum& datum) {
    Bindings bindings;
    return match(pattern, datum, bindings);
  };
  for (auto removal = removals_.rbegin(); removal != removals_.rend() && removal->revision > revision; ++removal) {
    if (fits(removal->datum)) return false;
  }
  bool unchanged = true;
  visit(pattern, [&](const Fact& fact) {
    unchanged = fact.revision <= revision || !fits(fact.datum);
    return unchanged;
  });
  return unchanged;
}

Datum FactTable::arguments_in(Mask mask, const Datum& datum) const {
  std::vector<Datum> arguments;
  arguments.reserve(static_cast<std::size_t>(std::popcount(mask)));
  for (std::size_t i = 0; i < relation_.arguments.size(); ++i) {
    if ((mask >> i & 1U) != 0) arguments.push_back(datum[i + 1]);
  }
  return Datum::list(std::move(arguments));
}

// The facts that an index finds for the pattern's ground arguments; null where looking through all is the way.
const std::set<FactId>* FactTable::bucket(const Datum& pattern) const {
  if (entries_.size() <= small_enough_to_look_through) return nullptr;
  Mask bound = 0;
  for (std::size_t i = 0; i < relation_.arguments.size(); ++i) {
    if (is_ground(pattern[i + 1])) bound |= Mask{1} << i;
  }
  if (bound == 0) return nullptr;
  Mask used = 0;
  const Index* index = index_for(bound, used);
  if (index == nullptr) return nullptr;
  const auto found = index->find(arguments_in(used, pattern));
  return found == index->end() ? &no_facts : &found->second;
}

const FactTable::Index* FactTable::index_for(Mask bound, Mask& used) const {
  used = bound;
  if (const auto exact = indexes_.find(bound); exact != indexes_.end()) return &exact->second;
  if (indexes_.size() < max_indexes) {
    Index& index = indexes_[bound];
    for (const auto& [id, entry] : entries_) index[arguments_in(bound, entry.fact.datum)].insert(id);
    return &index;
  }
  const Index* best = nullptr;
  used = 0;
  for (const auto& [mask, index] : indexes_) {
    if ((mask & ~bound) == 0 && std::popcount(mask) > std::popcount(used)) {
      best = &index;
      used = mask;
    }
  }
  return best;
}

}  // namespace pizarra
