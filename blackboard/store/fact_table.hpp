#pragma once

// The facts of one relation: by id, by key, and by whatever arguments queries have bound so far.
//
// An index over a set of argument positions is made when a pattern first binds just those and the table has grown
// beyond what is quicker to look through; patterns without one of their own use the best there is. In the same way one
// that is ordered by an argument is made when that is first compared or ordered by (table_indexes.hpp).
//
//   table.insert({fact, lease, expiry});
//   table.visit(pattern, [&](const Fact& fact) { return true; });    // candidates by ascending id; false stops
//   table.visit_within(pattern, ranges, visitor);                    // without most that are beyond the ranges
//   table.visit_ordered(pattern, {.argument = 1}, ranges, visitor);  // candidates by ascending argument
//
// Telling, retracting and finding by key cost the same however many facts there are.

#include <deque>
#include <map>
#include <optional>
#include <string>

#include "blackboard/relation.hpp"
#include "blackboard/store/fact_list.hpp"
#include "blackboard/store/hash_index.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/ordered_index.hpp"
#include "blackboard/store/table_indexes.hpp"

namespace pizarra::store {

class FactTable {
 public:
  static constexpr std::size_t max_removals = 4096;
  static constexpr std::size_t max_removed_bytes = 1 << 20;

  explicit FactTable(Relation relation) : relation_(std::move(relation)) {}
  FactTable(const FactTable&) = delete;
  FactTable& operator=(const FactTable&) = delete;

  const Relation& relation() const { return relation_; }
  std::size_t size() const { return facts_.size(); }
  // Their footprints.
  std::size_t bytes() const { return bytes_; }
  auto facts() const { return facts_.from(0); }

  StandingFact* find(FactId id) { return facts_.find(id); }
  // The one with the same key as `fact`.
  const StandingFact* find_key_of(const Datum& fact) const;
  StandingFact* find_key_of(const Datum& fact) {
    return const_cast<StandingFact*>(std::as_const(*this).find_key_of(fact));
  }
  // What that finds it by.
  std::size_t key_hash(const Datum& datum) const;
  // Whether at most one fact can fit: find_key_of() finds it.
  bool key_is_ground(const Datum& pattern) const;
  // None with its id or its key may stand.
  StandingFact& insert(StandingFact standing);
  // By a fact with the same key and an id higher than any; answers the former.
  Fact replace(StandingFact& standing, Fact fact);
  StandingFact remove(StandingFact& standing, Revision revision);

  // Calls `visitor` for every fact that may fit, and for all that do, until it answers false; for those with an id from
  // `first` on.
  template <class Visitor>
  void visit(const Datum& pattern, Visitor&& visitor, FactId first = 0) const {
    if (key_is_ground(pattern)) {
      const StandingFact* only = find_key_of(pattern);
      if (only != nullptr && only->fact.id >= first) visitor(only->fact);
      return;
    }
    if (const Bucket* bucket = bucket_for(pattern)) {
      for (auto i = bucket->lower_bound(first); i != bucket->end(); ++i) {
        if (!visitor(i->second->fact)) return;
      }
      return;
    }
    for (const StandingFact& standing : facts_.from(first)) {
      if (!visitor(standing.fact)) return;
    }
  }
  // Facts outside of the ranges may be among those that it calls for, but no more than there are in the smallest of
  // them: it goes through the facts by id and through the ranges side by side, until one ends.
  template <class Visitor>
  void visit_within(const Datum& pattern, std::span<const ValueRange> ranges, Visitor&& visitor) const {
    const std::vector<OrderedFacts> within = ordered_within(pattern, ranges);
    std::vector<OrderedFacts> left = within;
    std::optional<std::size_t> ended;
    FactId next = 0;
    visit(pattern, [&](const Fact& fact) {
      next = fact.id;
      ended = step(left);
      return !ended && visitor(fact);
    });
    if (!ended) return;
    for (const StandingFact* standing : by_id(within[*ended], next)) {
      if (!visitor(standing->fact)) return;
    }
  }
  struct Order {
    std::size_t argument;
    bool descending = false;
  };
  // By the argument's value, those with the same by id. False where that is not the way: there is no such index, or it
  // has called for as many facts as visit_within() would.
  template <class Visitor>
  bool visit_ordered(const Datum& pattern, Order order, std::span<const ValueRange> ranges, Visitor&& visitor) const {
    std::size_t left_of_pattern = candidates(pattern);
    if (is_few(left_of_pattern)) return false;
    const FactIndex* by_order = ordered_index_for(order.argument);
    if (by_order == nullptr) return false;
    const OrderedIndex& index = by_order->in_order();
    ValueRange own{.argument = order.argument};
    std::vector<ValueRange> others;
    for (const ValueRange& range : ranges) {
      if (range.argument == order.argument) own = range;
      if (range.argument != order.argument) others.push_back(range);
    }
    std::vector<OrderedFacts> left = ordered_within(pattern, others);
    bool is_shorter = true;
    const auto consider = [&](const StandingFact* standing) {
      is_shorter = left_of_pattern-- > 0 && !step(left);
      return is_shorter && visitor(standing->fact);
    };
    const OrderedFacts all = facts_within(index, own);
    auto begin = order.descending ? all.end() : all.begin();
    auto end = all.end();
    do {
      // Those with the highest value that is left.
      if (begin == end && begin != all.begin()) begin = first_with_value_of(index, *std::prev(end));
      if (std::find_if_not(begin, end, consider) != end) return is_shorter;
      end = begin;
    } while (end != all.begin());
    return true;
  }
  // How many facts visit() considers at most.
  std::size_t candidates(const Datum& pattern) const;
  // As many facts could be looked at while one goes.
  std::size_t looks_to_remove() const;
  // And while its indexes learn that one comes or goes.
  std::size_t looks_of_indexes() const;
  // Whether looking through so many is quicker than an index.
  static bool is_few(std::size_t facts);
  // Whether no fact that fits came or went after `revision`. False, too, when the removals since then are forgotten:
  // the last 4096 are remembered, up to a megabyte.
  // False, too, where that takes looking at more than is allowed.
  bool unchanged_since(const Datum& pattern, Revision revision, Looking& looking) const;
  // What went until then was never known here.
  void forget_removals(Revision until) { removals_forgotten_ = until; }

 private:
  using Bucket = FactIndex::Bucket;
  using Mask = FactIndex::Mask;
  bool same_key(const Datum& a, const Datum& b) const;
  Mask ground_arguments(const Datum& pattern) const;
  // Null where looking through all is the way.
  const Bucket* bucket_for(const Datum& pattern) const;
  // Null where looking through all is quicker, or it is not to be had.
  const FactIndex* ordered_index_for(std::size_t argument) const;
  // Of each range that an index finds.
  std::vector<OrderedFacts> ordered_within(const Datum& pattern, std::span<const ValueRange> ranges) const;
  static OrderedIndex::const_iterator first_with_value_of(const OrderedIndex& index, const StandingFact* standing) {
    return index.lower_bound(ByArgument::Edge{index.key_comp().value(standing), false});
  }
  // On by one fact each; which of them had none.
  static std::optional<std::size_t> step(std::vector<OrderedFacts>& all);
  // Those with an id from `first` on.
  static std::vector<const StandingFact*> by_id(const OrderedFacts& facts, FactId first);
  void went(Revision revision, const Fact& fact);

  Relation relation_;
  FactList facts_;
  std::size_t bytes_ = 0;
  HashIndex<StandingFact> by_key_;
  mutable TableIndexes indexes_{facts_};
  struct Removal {
    Revision revision;
    Datum datum;
    std::size_t bytes;
  };
  std::deque<Removal> removals_;
  std::size_t removed_bytes_ = 0;
  Revision removals_forgotten_ = 0;
};

// The relations of a board by name.
using Tables = std::map<std::string, FactTable, std::less<>>;

}  // namespace pizarra::store
