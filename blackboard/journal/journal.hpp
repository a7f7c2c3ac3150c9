#pragma once

// The journal: every declaration and committed transaction as one line of text, which says the same thing for the same
// run, and the way back.
//
//   (0 1500000 "vision" (declare (relation seen ((name string)) (key name))))
//   (1 1500000 "vision" (tell 1 (seen "circle") (because 3 4)) (retract 2) (take 5) (settle 5) (return 5 9))
//
// A line begins with the revision, the time in microseconds and the teller. `tell` gives the new fact's id, `return`
// the id of a taken fact and its new one. Of a durable fact it is said whether it goes with a lease: `(tell 1 (goal 1)
// leased)`, `(return 1 2 leased)`, and where that changes, `(leased 1)` and `(kept 1)`. The renewal of a lease is no
// change and has no line.
//
//   Store store;
//   Result<std::string_view> rest = replay(text, store);          // all of it, or up to a revision or a time

#include <string>
#include <string_view>
#include <variant>

#include "blackboard/store/store.hpp"

namespace pizarra::journal {

std::string journal_line(const store::Commit& commit);
std::string journal_line(Revision revision, Time when, const std::string& teller,
                         const std::vector<Relation>& declared);

struct Declaration {
  std::vector<Relation> relations;
};
// Of the facts that a line removes or takes, only the ids are known. Failure bad-journal.
Result<std::variant<Declaration, store::Commit>> read_journal_line(std::string_view line);

// What a line begins with, without reading the rest.
struct LineStart {
  Revision revision = 0;
  Time when{};
};
LineStart start_of_line(std::string_view line);
// Of lines that each have their newline.
LineStart start_of_last_line(std::string_view lines);
inline bool is_beyond(const LineStart& start, const Moment& until) {
  return start.revision > until.revision || start.when > until.time;
}

// Repeats one line in `store`: failure bad-journal.
Result<void> replay_line(std::string_view line, store::Store& store);

// Repeats the lines in order up to a moment, and answers those that are left. A last line without its newline was torn
// by a crash, and is left out.
Result<std::string_view> replay(std::string_view text, store::Store& store, const Moment& until = {});

// What a question about a revision failed with: that a relation is not declared is true of that revision.
Failure failure_at(Revision revision, Failure failure);

}  // namespace pizarra::journal
