#pragma once

// The facts of one relation: by id, by key, and by whatever arguments queries have bound so far.
//
// An index over a set of argument positions is made when a pattern first binds just those and the table has grown
// beyond what is quicker to look through; at most eight a table, after which patterns use the best there is.
//
//   table.insert({fact, lease, expiry});
//   table.visit(pattern, [&](const Fact& fact) { return true; });    // candidates by ascending id; false stops

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "blackboard/fact.hpp"
#include "blackboard/relation.hpp"

namespace pizarra {

class FactTable {
 public:
  struct Entry {
    Fact fact;
    LeaseId lease = 0;
    std::optional<Time> expiry = {};  // by the relation's own lease
  };
  using Visitor = std::function<bool(const Fact&)>;
  static constexpr std::size_t max_indexes = 8;
  static constexpr std::size_t max_removals = 4096;

  explicit FactTable(Relation relation) : relation_(std::move(relation)) {}

  const Relation& relation() const { return relation_; }
  std::size_t size() const { return entries_.size(); }
  const std::map<FactId, Entry>& entries() const { return entries_; }

  Entry* find(FactId id);
  // The entry with the same key as `fact`.
  Entry* find_key_of(const Datum& fact);
  // No entry with its id or its key may stand.
  Entry& insert(Entry entry);
  Entry remove(FactId id, Revision revision);

  // Calls `visitor` for every fact that may fit, and for all that do, until it answers false.
  void visit(const Datum& pattern, const Visitor& visitor) const;
  // Whether no fact that fits came or went after `revision`. False, too, when the removals since then are forgotten:
  // the last 4096 are remembered.
  bool unchanged_since(const Datum& pattern, Revision revision) const;

 private:
  using Index = std::unordered_map<Datum, std::set<FactId>>;
  using Mask = std::uint32_t;

  Datum arguments_in(Mask mask, const Datum& datum) const;
  const std::set<FactId>* bucket(const Datum& pattern) const;
  const Index* index_for(Mask bound, Mask& used) const;

  Relation relation_;
  std::map<FactId, Entry> entries_;
  std::unordered_map<Datum, FactId> by_key_;
  mutable std::map<Mask, Index> indexes_;
  struct Removal {
    Revision revision;
    Datum datum;
  };
  std::deque<Removal> removals_;
  Revision removals_forgotten_ = 0;
};

// The relations of a board by name.
using Tables = std::map<std::string, FactTable, std::less<>>;

}  // namespace pizarra
