#pragma once

// The facts of one relation: by id, by key, and by whatever arguments queries have bound so far.
//
// An index over a set of argument positions is made when a pattern first binds just those and the table has grown
// beyond what is quicker to look through; at most eight a table, after which patterns use the best there is.
//
//   table.insert({fact, lease, expiry});
//   table.visit(pattern, [&](const Fact& fact) { return true; });    // candidates by ascending id; false stops
//
// Telling, retracting and finding by key cost the same however many facts there are.

#include <deque>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>

#include "blackboard/relation.hpp"
#include "blackboard/store/fact_list.hpp"
#include "blackboard/store/hash_index.hpp"

namespace pizarra {

class FactTable {
 public:
  static constexpr std::size_t max_indexes = 8;
  static constexpr std::size_t max_removals = 4096;
  static constexpr std::size_t max_removed_bytes = 1 << 20;

  explicit FactTable(Relation relation) : relation_(std::move(relation)) {}
  FactTable(const FactTable&) = delete;
  FactTable& operator=(const FactTable&) = delete;

  const Relation& relation() const { return relation_; }
  std::size_t size() const { return facts_.size(); }
  auto facts() const { return facts_.from(0); }

  StandingFact* find(FactId id) { return facts_.find(id); }
  // The one with the same key as `fact`.
  const StandingFact* find_key_of(const Datum& fact) const;
  StandingFact* find_key_of(const Datum& fact) {
    return const_cast<StandingFact*>(std::as_const(*this).find_key_of(fact));
  }
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
    } else if (const Bucket* bucket = bucket_for(pattern)) {
      for (auto i = bucket->lower_bound(first); i != bucket->end(); ++i) {
        if (!visitor(i->second->fact)) return;
      }
    } else {
      for (const StandingFact& standing : facts_.from(first)) {
        if (!visitor(standing.fact)) return;
      }
    }
  }
  // How many facts visit() considers at most.
  std::size_t candidates(const Datum& pattern) const;
  // Whether no fact that fits came or went after `revision`. False, too, when the removals since then are forgotten:
  // the last 4096 are remembered, up to a megabyte.
  bool unchanged_since(const Datum& pattern, Revision revision) const;
  // What went until then was never known here.
  void forget_removals(Revision until) { removals_forgotten_ = until; }

 private:
  using Bucket = std::map<FactId, const StandingFact*>;
  using Index = std::unordered_map<Datum, Bucket>;
  using Mask = std::uint32_t;

  std::size_t key_hash(const Datum& datum) const;
  bool same_key(const Datum& a, const Datum& b) const;
  Datum arguments_in(Mask mask, const Datum& datum) const;
  void enter_indexes(const StandingFact& standing);
  void leave_indexes(const StandingFact& standing);
  const Bucket* bucket_for(const Datum& pattern) const;
  const Index* index_for(Mask bound, Mask& used) const;
  void remember_removal(Revision revision, const Datum& datum);

  Relation relation_;
  FactList facts_;
  HashIndex<StandingFact> by_key_;
  mutable std::map<Mask, Index> indexes_;
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

}  // namespace pizarra
