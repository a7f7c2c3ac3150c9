#include "blackboard/store/fact_table.hpp"

#include <algorithm>

#include "blackboard/limits.hpp"
#include "lisp/keyed_hash.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::store {

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
  indexes_.enter(inserted);
  return inserted;
}

Fact FactTable::replace(StandingFact& standing, Fact fact) {
  went(fact.revision, standing.fact);
  bytes_ += footprint(fact);
  indexes_.leave(standing);
  Fact former = facts_.replace(standing, std::move(fact));
  indexes_.enter(standing);
  return former;
}

StandingFact FactTable::remove(StandingFact& standing, Revision revision) {
  by_key_.erase(key_hash(standing.fact.datum), &standing);
  indexes_.leave(standing);
  went(revision, standing.fact);
  return facts_.remove(standing);
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

FactTable::Mask FactTable::ground_arguments(const Datum& pattern) const {
  Mask ground = 0;
  for (std::size_t i = 0; i < relation_.arguments.size(); ++i) {
    if (is_ground(pattern[i + 1])) ground |= Mask{1} << i;
  }
  return ground;
}

std::size_t FactTable::looks_to_remove() const {
  constexpr std::size_t of_the_table = 8;
  return of_the_table + looks_of_indexes();
}

std::size_t FactTable::looks_of_indexes() const {
  constexpr std::size_t of_an_index = 4;
  return of_an_index * indexes_.size();
}

const FactTable::Bucket* FactTable::bucket_for(const Datum& pattern) const {
  static const Bucket none;
  if (is_few(size())) return nullptr;
  const Mask bound = ground_arguments(pattern);
  if (bound == 0) return nullptr;
  const FactIndex* index = indexes_.find(FactIndex::by_values(bound));
  if (Indexing::is_awaiting()) return &none;
  if (index == nullptr) index = indexes_.best_by_values(bound);
  return index == nullptr ? nullptr : &index->bucket_of(pattern);
}

// An index by lists would compare them with every fact that comes or goes, however long they are.
const FactIndex* FactTable::ordered_index_for(std::size_t argument) const {
  const ArgumentType type = relation_.arguments[argument].type;
  const bool may_be_list = type == ArgumentType::list || type == ArgumentType::datum;
  return may_be_list || is_few(size()) ? nullptr : indexes_.find(FactIndex::by_order(argument));
}

std::vector<OrderedFacts> FactTable::ordered_within(const Datum& pattern, std::span<const ValueRange> ranges) const {
  std::vector<OrderedFacts> within;
  if (ranges.empty() || is_few(candidates(pattern))) return within;
  for (const ValueRange& range : ranges) {
    const FactIndex* index = ordered_index_for(range.argument);
    if (index != nullptr) within.push_back(facts_within(index->in_order(), range));
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

}  // namespace pizarra::store
