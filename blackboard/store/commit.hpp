#pragma once

// The changes of one transaction, as the store hands them to the journal and to the watches.
//
// A fact that is told in place of another appears as the other's `retracted` followed by its own `told`. A fact told
// and removed within one transaction does not appear at all.
//
//   store.on_commit([&](const Commit& commit) {
//     for (const Commit::Entry& entry : commit.entries) {
//       if (adds(entry)) show(entry.fact);
//     }
//   });

#include <functional>
#include <string_view>

#include "blackboard/fact.hpp"

namespace pizarra::store {

struct Commit {
  struct Entry {
    enum class Kind : std::uint8_t {
      told,       // `fact` stands now
      retracted,  // `fact` stands no more
      taken,      // `fact` stands no more and is held for its taker
      settled,    // the held `fact` will not come back
      returned,   // the held fact with id `former` stands again, as `fact`
      leased,     // `fact`, which stands and is durable, goes with a lease from now on
      kept        // ... and from now on with none
    };
    Kind kind;
    Fact fact;
    FactId former = 0;
    bool under_lease = false;  // what was told or returned is durable, and goes with a lease
    bool operator==(const Entry&) const = default;
  };

  Revision revision = 0;
  Time when{};
  std::string teller;
  std::vector<Entry> entries;
  bool operator==(const Commit&) const = default;
};

inline bool adds(const Commit::Entry& entry) {
  return entry.kind == Commit::Entry::Kind::told || entry.kind == Commit::Entry::Kind::returned;
}
inline bool removes(const Commit::Entry& entry) {
  return entry.kind == Commit::Entry::Kind::retracted || entry.kind == Commit::Entry::Kind::taken;
}

// Receives a line of the journal, without its newline.
using JournalSink = std::function<void(std::string_view line)>;

}  // namespace pizarra::store
