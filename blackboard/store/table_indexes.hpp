#pragma once

// The indexes of one table: each is made when it is first needed, at most eight by values and four by order. When there
// are as many, another one takes the place of the least lately used, if that was not looked for in a hundred times.
//
//   const FactIndex* index = indexes.find(kind);       // null where it is not to be had, or must be awaited
//
// How they are made, the Indexing says (indexing.hpp). One that is not made yet is the maker's (index_maker.hpp):
// nobody else makes it, and it does not go. One that goes stays until facts change or others are made, since somebody
// may be going through it, and is taken apart a few facts at a time.

#include <map>
#include <memory>

#include "blackboard/store/fact_index.hpp"

namespace pizarra::store {

class TableIndexes {
 public:
  using Kind = FactIndex::Kind;
  static constexpr std::size_t most_by_values = 8;
  static constexpr std::size_t most_by_order = 4;

  explicit TableIndexes(const FactList& facts) : facts_(facts) {}
  TableIndexes(const TableIndexes&) = delete;
  TableIndexes& operator=(const TableIndexes&) = delete;

  std::size_t size() const { return entries_.size(); }
  const FactIndex* find(const Kind& kind);
  // By the most of these arguments; null where there is none.
  const FactIndex* best_by_values(FactIndex::Mask bound);

  // When the fact stands, and while it still stands.
  void enter(const StandingFact& standing);
  void leave(const StandingFact& standing);

  // For the maker: goes on making one that it began, between searches; answers whether it is made.
  void begin(const Kind& kind);
  bool make_some(const Kind& kind, Looking& looking);

 private:
  struct Entry {
    Entry(const Kind& kind, const FactList& facts) : index(kind, facts) {}
    FactIndex index;
    std::uint64_t used = 0;  // of TableIndexes' uses_, the last
  };
  using Entries = std::map<Kind, Entry>;

  bool has_place_for(const Kind& kind);
  bool is_full(Kind::By by) const;
  Entries::iterator least_lately_used(Kind::By by);
  void make_at_once(FactIndex& index);
  void take_apart_some();

  const FactList& facts_;
  Entries entries_;
  std::uint64_t uses_ = 0;
  Entries::node_type gone_;  // and is being taken apart
};

}  // namespace pizarra::store
