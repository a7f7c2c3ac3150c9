#pragma once

// How kept facts live again from a journal: what stood where it begins is put back, its commits are repeated, and then
// the facts are made live.
//
//   restored = restore(kept, fact, Restored::standing);
//   applied = apply(kept, commit);
//   resume(kept, now);

#include "blackboard/store/kept_facts.hpp"

namespace pizarra::store {

// How a fact was kept at the revision where the journal begins, and whether it was told under a lease.
enum class Restored : std::uint8_t { standing, taken, leased, taken_leased };

// By ascending ids. Failure bad-journal.
Result<void> restore(KeptFacts& kept, Fact fact, Restored as);
// Repeats a commit of another board, in order; a failure says why it cannot have happened here. Of facts that it
// removes, only the ids need be known.
Result<void> apply(KeptFacts& kept, Commit commit);
// After the last apply: facts of relations that are not durable go, and durable ones that stood under a lease, for no
// lease outlives the board that gave it; what was taken comes back, and leased relations' facts begin their leases.
void resume(KeptFacts& kept, Time now);

}  // namespace pizarra::store
