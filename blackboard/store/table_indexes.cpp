#include "blackboard/store/table_indexes.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "blackboard/store/looking.hpp"
#include "lisp/elements_looked_at.hpp"

namespace pizarra::store {

namespace {

using By = FactIndex::Kind::By;

// Without which an index may go.
constexpr std::uint64_t uses_of_others = 100;
// With each change, or with each part of another.
constexpr std::size_t taken_apart_at_once = 64;

}  // namespace

const FactIndex* TableIndexes::find(const Kind& kind) {
  ++uses_;
  auto found = entries_.find(kind);
  const bool is_begun = found != entries_.end();
  if (!is_begun || !found->second.index.is_made()) {
    if ((!is_begun && !has_place_for(kind)) || !Indexing::may_make() || Indexing::is_awaiting()) return nullptr;
    // The one who began an index makes it, however few facts are left.
    if (is_begun || !Indexing::makes_at_once(facts_.size())) {
      Indexing::await(*this, kind);
      return nullptr;
    }
    begin(kind);
    found = entries_.find(kind);
    make_at_once(found->second.index);
  }
  found->second.used = uses_;
  return &found->second.index;
}

void TableIndexes::make_at_once(FactIndex& index) {
  const UncountedEffort for_all_to_come;
  std::size_t examined = 0;
  Looking looking(examined, std::numeric_limits<std::size_t>::max());
  index.make_some(facts_, looking);
  Indexing::made_at_once(facts_.size());
}

const FactIndex* TableIndexes::best_by_values(FactIndex::Mask bound) {
  Entry* best = nullptr;
  const auto known = [](const Entry* entry) { return entry == nullptr ? 0 : std::popcount(entry->index.kind().which); };
  for (auto& [kind, entry] : entries_) {
    const bool serves = kind.by == By::values && (kind.which & ~bound) == 0 && entry.index.is_made();
    if (serves && known(&entry) > known(best)) best = &entry;
  }
  if (best == nullptr) return nullptr;
  best->used = uses_;
  return &best->index;
}

void TableIndexes::enter(const StandingFact& standing) {
  if (!gone_.empty()) take_apart_some();
  for (auto& [kind, entry] : entries_) entry.index.enter(standing);
}

void TableIndexes::leave(const StandingFact& standing) {
  if (!gone_.empty()) take_apart_some();
  for (auto& [kind, entry] : entries_) entry.index.leave(standing);
}

void TableIndexes::begin(const Kind& kind) {
  if (entries_.contains(kind)) return;
  if (is_full(kind.by)) gone_ = entries_.extract(least_lately_used(kind.by));
  entries_.try_emplace(kind, kind, facts_);
}

bool TableIndexes::make_some(const Kind& kind, Looking& looking) {
  if (!gone_.empty()) take_apart_some();
  FactIndex& index = entries_.find(kind)->second.index;
  index.make_some(facts_, looking);
  return index.is_made();
}

void TableIndexes::take_apart_some() {
  if (gone_.mapped().index.take_apart(taken_apart_at_once)) gone_ = {};
}

bool TableIndexes::has_place_for(const Kind& kind) {
  if (!is_full(kind.by)) return true;
  const auto least = least_lately_used(kind.by);
  return gone_.empty() && least != entries_.end() && uses_ - least->second.used >= uses_of_others;
}

bool TableIndexes::is_full(Kind::By by) const {
  const auto all = std::ranges::count_if(entries_, [by](const auto& entry) { return entry.first.by == by; });
  return static_cast<std::size_t>(all) >= (by == By::values ? most_by_values : most_by_order);
}

// Of those that are made.
TableIndexes::Entries::iterator TableIndexes::least_lately_used(Kind::By by) {
  auto least = entries_.end();
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry) {
    if (entry->first.by != by || !entry->second.index.is_made()) continue;
    if (least == entries_.end() || entry->second.used < least->second.used) least = entry;
  }
  return least;
}

}  // namespace pizarra::store
