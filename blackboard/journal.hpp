#pragma once

// The journal: every declaration and committed transaction as one line of text, which says the same thing for the same
// run, and the way back.
//
//   (0 1500000 "vision" (declare (relation seen ((name string)) (key name))))
//   (1 1500000 "vision" (tell 1 (seen "circle") (because 3 4)) (retract 2) (take 5) (settle 5) (return 5 9))
//
// A line begins with the revision, the time in microseconds and the teller. `tell` gives the new fact's id, `return`
// the id of a taken fact and its new one. A leased fact's renewal is no change and has no line.
//
//   Store store;
//   Result<void> replayed = replay(text, store);                  // all of it, or up to a revision

#include <limits>
#include <string>
#include <string_view>

#include "blackboard/store.hpp"

namespace pizarra {

std::string journal_line(const Commit& commit);
std::string journal_line(Revision revision, Time when, const std::string& teller,
                         const std::vector<Relation>& declared);

// Repeats one line in `store`: failure bad-journal.
Result<void> replay_line(std::string_view line, Store& store);

// Repeats the lines up to `last`. A last line without its newline was torn by a crash, and is left out.
Result<void> replay(std::string_view text, Store& store, Revision last = std::numeric_limits<Revision>::max());

}  // namespace pizarra
