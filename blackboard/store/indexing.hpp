#pragma once

// While one lives on a thread, it says whether the work on that thread may make indexes, and how, and counts what they
// cost its client. Making an index does not count for the bound of a search, because it pays off later.
//
//   Indexing indexing(Indexing::May::make_in_parts, &maker);
//   store.ask(query, examined);                    // what must await an index ends at once, and fails
//   if (indexing.awaited() != 0) ...               // it is to be done again when the maker has made it
//   examined + indexing.examined();                // as many facts could have been looked at meanwhile
//
// The innermost one on a thread counts. Where there is none, every index is made at once.

#include <cstddef>
#include <cstdint>

#include "blackboard/store/fact_index.hpp"

namespace pizarra::store {

class IndexMaker;
class TableIndexes;

// Awaits the maker of indexes until so many are made; 0 awaits nothing.
using IndexTicket = std::uint64_t;

class Indexing {
 public:
  // In parts: but for small ones.
  enum class May : std::uint8_t { not_make, make_in_parts, make_at_once };
  static constexpr std::size_t looks_a_fact = 16;

  explicit Indexing(May may, IndexMaker* maker = nullptr) : may_(may), maker_(maker) { innermost = this; }
  Indexing(const Indexing&) = delete;
  Indexing& operator=(const Indexing&) = delete;
  ~Indexing() { innermost = outer_; }

  std::size_t examined() const { return looks_a_fact * facts_; }
  IndexTicket awaited() const { return awaited_; }

  static bool may_make() { return innermost == nullptr || innermost->may_ != May::not_make; }
  // Where it may be made. Over so many facts.
  static bool makes_at_once(std::size_t facts);
  static void made_at_once(std::size_t facts) {
    if (innermost != nullptr) innermost->facts_ += facts;
  }
  static void await(TableIndexes& table, const FactIndex::Kind& kind);
  static void await(IndexTicket ticket) {
    if (innermost != nullptr) innermost->awaited_ = ticket;
  }
  static bool is_awaiting() { return innermost != nullptr && innermost->awaited_ != 0; }

 private:
  static inline thread_local Indexing* innermost = nullptr;
  Indexing* const outer_ = innermost;
  const May may_;
  IndexMaker* const maker_;
  std::size_t facts_ = 0;  // that indexes were made of at once
  IndexTicket awaited_ = 0;
};

}  // namespace pizarra::store
