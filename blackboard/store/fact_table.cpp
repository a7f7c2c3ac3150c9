#include "blackboard/store/fact_table.hpp"

#include <algorithm>
#include <bit>

#include "blackboard/limits.hpp"
#include "blackboard/store/compare_values.hpp"
#include "blackboard/store/indexing.hpp"
#include "lisp/effort.hpp"
#include "lisp/keyed_hash.hpp"
#include "lisp/pattern.hpp"

namespace pizarra {

namespace {

constexpr std::size_t small_enough_to_look_through = 16;

}  // namespace

const StandingFact* FactTable::find_key_of(const Datum& fact) const {
  return by_key_.find(key_hash(fact),
                      [&](const StandingFact& standing) { return same_key(standing.fact.datum, fact); });
}

StandingFact& FactTable::insert(StandingFact standing) {
  standing.table = this;
  StandingFact& inserted = facts_.insert(std::move(standing));
  bytes_ += footprint(inserted.fact);
  by_key_.insert(key_hash(inserted.fact.datum), &inserted);
  enter_indexes(inserted);
  return inserted;
}

Fact FactTable::replace(StandingFact& standing, Fact fact) {
  went(fact.revision, standing.fact);
  bytes_ += footprint(fact);
  leave_indexes(standing);
  Fact former = facts_.replace(standing, std::move(fact));
  enter_indexes(standing);
  return former;
}

StandingFact FactTable::remove(StandingFact& standing, Revision revision) {
  by_key_.erase(key_hash(standing.fact.datum), &standing);
  leave_indexes(standing);
  went(revision, standing.fact);
  return facts_.remove(standing);
}

void FactTable::enter_indexes(const StandingFact& standing) {
  for (auto& [mask, index] : indexes_) {
    index[arguments_in(mask, standing.fact.datum)].emplace(standing.fact.id, &standing);
  }
  for (auto& [argument, index] : ordered_) index.insert(&standing);
}

void FactTable::leave_indexes(const StandingFact& standing) {
  for (auto& [argument, index] : ordered_) index.erase(&standing);
  for (auto& [mask, index] : indexes_) {
    const auto place = index.find(arguments_in(mask, standing.fact.datum));
    place->second.erase(standing.fact.id);
    if (place->second.empty()) index.erase(place);
  }
}

void FactTable::went(Revision revision, const Fact& fact) {
  const Weight weight = weigh(fact.datum);
  bytes_ -= footprint(fact, weight);
  removals_.push_back({revision, fact.datum, weight.bytes});
  removed_bytes_ += removals_.back().bytes;
  while (removals_.size() > max_removals || removed_bytes_ > max_removed_bytes) {
    removals_forgotten_ = removals_.front().revision;
    removed_bytes_ -= removals_.front().bytes;
    removals_.pop_front();
  }
}

bool FactTable::unchanged_since(const Datum& pattern, Revision revision, Looking& looking) const {
  if (revision < removals_forgotten_) return false;
  const auto fits = [&](const Datum& datum) {
    Bindings bindings;
    return match(pattern, datum, bindings);
  };
  for (auto removal = removals_.rbegin(); removal != removals_.rend() && removal->revision > revision; ++removal) {
    if (!looking.at_one_more() || fits(removal->datum)) return false;
  }
  bool unchanged = true;
  visit(pattern, [&](const Fact& fact) {
    unchanged = looking.at_one_more() && (fact.revision <= revision || !fits(fact.datum));
    return unchanged;
  });
  return unchanged;
}

std::size_t FactTable::candidates(const Datum& pattern) const {
  if (key_is_ground(pattern)) return 1;
  const Bucket* bucket = bucket_for(pattern);
  return bucket != nullptr ? bucket->size() : size();
}

bool FactTable::key_is_ground(const Datum& pattern) const {
  return std::ranges::all_of(relation_.key, [&](std::size_t position) { return is_ground(pattern[position + 1]); });
}

std::size_t FactTable::key_hash(const Datum& datum) const {
  std::size_t hash = 0;
  for (const std::size_t position : relation_.key) hash = keyed_mix(hash, datum[position + 1].hash());
  return hash;
}

bool FactTable::same_key(const Datum& a, const Datum& b) const {
  return std::ranges::all_of(relation_.key, [&](std::size_t position) { return a[position + 1] == b[position + 1]; });
}

Datum FactTable::arguments_in(Mask mask, const Datum& datum) {
  std::vector<Datum> arguments;
  arguments.reserve(static_cast<std::size_t>(std::popcount(mask)));
  for (std::size_t i = 0; i + 1 < datum.size(); ++i) {
    if ((mask >> i & 1U) != 0) arguments.push_back(datum[i + 1]);
  }
  return Datum::list(std::move(arguments));
}

FactTable::Mask FactTable::ground_arguments(const Datum& pattern) const {
  Mask ground = 0;
  for (std::size_t i = 0; i < relation_.arguments.size(); ++i) {
    if (is_ground(pattern[i + 1])) ground |= Mask{1} << i;
  }
  return ground;
}

FactTable::Mask FactTable::found_by(const Datum& pattern) const {
  const Mask bound = ground_arguments(pattern);
  Mask used = 0;
  if (bound != 0) index_for(bound, used);
  return used;
}

// The facts that an index finds for the pattern's ground arguments; null where looking through all is the way.
const FactTable::Bucket* FactTable::bucket_for(const Datum& pattern) const {
  static const Bucket none;
  if (facts_.size() <= small_enough_to_look_through) return nullptr;
  const Mask bound = ground_arguments(pattern);
  if (bound == 0) return nullptr;
  Mask used = 0;
  const Index* index = index_for(bound, used);
  if (index == nullptr) return nullptr;
  const auto found = index->find(arguments_in(used, pattern));
  return found == index->end() ? &none : &found->second;
}

const FactTable::Index* FactTable::index_for(Mask bound, Mask& used) const {
  used = bound;
  if (const auto exact = indexes_.find(bound); exact != indexes_.end()) return &exact->second;
  if (indexes_.size() < max_indexes && Indexing::may_make()) {
    const UncountedEffort for_all_to_come;
    Indexing::made(size());
    Index& index = indexes_[bound];
    for (const StandingFact& standing : facts()) {
      Bucket& bucket = index[arguments_in(bound, standing.fact.datum)];
      bucket.emplace_hint(bucket.end(), standing.fact.id, &standing);
    }
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

const OrderedIndex* FactTable::ordered_index_for(std::size_t argument) const {
  if (facts_.size() <= small_enough_to_look_through) return nullptr;
  const auto made = ordered_.find(argument);
  if (made != ordered_.end()) return &made->second;
  if (ordered_.size() >= max_ordered_indexes || !Indexing::may_make()) return nullptr;
  const UncountedEffort for_all_to_come;
  Indexing::made(size());
  const ByArgument before{argument};
  // Their values beside them, for each is compared often and lies elsewhere; those with the same stay in their order.
  std::vector<std::pair<Datum, const StandingFact*>> sorted;
  sorted.reserve(size());
  for (const StandingFact& standing : facts()) sorted.emplace_back(before.value(&standing), &standing);
  std::ranges::stable_sort(
      sorted, [](const Datum& a, const Datum& b) { return compare_values(a, b) < 0; },
      &decltype(sorted)::value_type::first);
  const auto by_value = sorted | std::views::values;
  return &ordered_.emplace(argument, OrderedIndex(by_value.begin(), by_value.end(), before)).first->second;
}

std::vector<OrderedFacts> FactTable::ordered_within(const Datum& pattern, std::span<const ValueRange> ranges) const {
  std::vector<OrderedFacts> within;
  if (ranges.empty() || is_few(candidates(pattern))) return within;
  for (const ValueRange& range : ranges) {
    const OrderedIndex* index = ordered_index_for(range.argument);
    if (index != nullptr) within.push_back(facts_within(*index, range));
  }
  return within;
}

bool FactTable::is_few(std::size_t facts) { return facts <= small_enough_to_look_through; }

std::optional<std::size_t> FactTable::step(std::vector<OrderedFacts>& all) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].empty()) return i;
    all[i].advance(1);
  }
  return std::nullopt;
}

std::vector<const StandingFact*> FactTable::by_id(const OrderedFacts& facts, FactId first) {
  const auto id = [](const StandingFact* standing) { return standing->fact.id; };
  std::vector<const StandingFact*> sorted;
  std::ranges::copy_if(facts, std::back_inserter(sorted), [&](const StandingFact* s) { return id(s) >= first; });
  std::ranges::sort(sorted, {}, id);
  return sorted;
}

}  // namespace pizarra
