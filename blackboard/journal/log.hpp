#pragma once

// Where a board's journal is kept: the wall that JournalWriter writes to. An SQLite file is one (journal_file.hpp), for
// a board that is alone; an etcd cluster is another (blackboard/cluster/cluster_log.hpp), for boards that take over.
//
//   Store store;
//   Result<std::vector<RememberedReply>> replies = log.recover(store);          // before anything is appended
//   log.append({lines, replies, true});          // it lasts when this returns
//   while (*log.compact(now) > 0) {}             // a slice at a time
//
// Calls may come from any thread, one after another; read() may come beside them. Failures: journal-full, bad-journal,
// journal-file as of the file; unavailable (whether the group was written is not known: the same group is to be
// appended again, which writes it once) and deposed (another board leads: nothing is ever written again).

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/journal/journal.hpp"
#include "blackboard/journal/journal_room.hpp"
#include "blackboard/journal/remembered_replies.hpp"

namespace pizarra::journal {

// Lines that are written together, each with its newline: all of them survive, or none.
struct JournalGroup {
  std::string lines;
  std::string replies;
  bool durable = false;  // whether it is worth waiting for the disk

  std::size_t bytes() const { return lines.size() + replies.size(); }
};

// A journal as of a moment.
struct PlayedBack {
  LineStart to;
  std::string later;                  // the lines that came after
  std::optional<Failure> lacks = {};  // why only what is durable is there, where that is so
};

// Turns it into the failure `not-yet` if the journal ends before that revision.
Result<PlayedBack> check_reached(Result<PlayedBack> played, const Moment& until);

class Log {
 public:
  virtual ~Log() = default;

  // As people name it.
  virtual const std::string& path() const = 0;
  // All of it, into an empty store.
  virtual Result<std::vector<RememberedReply>> recover(store::Store& store) = 0;
  // On a full disk the last of the space is used where `may_spend`.
  virtual Result<void> append(const JournalGroup& group, bool may_spend) = 0;
  // What there is space for in any case: tries to set it aside again when it was used up.
  virtual JournalRoom room() = 0;
  // How many bytes of groups went from the log; 0 when there are none to go.
  virtual Result<std::size_t> compact(Time now) = 0;
  // As it was at a moment, into an empty store. Failure `forgotten` when compaction has let that moment go, `not-yet`
  // when there is no such revision, unless the log lacks what is not durable and cannot know.
  virtual Result<PlayedBack> read(store::Store& store, const Moment& until) const = 0;
  // The bytes after which a group should end and the next one begin.
  virtual std::size_t group_bytes() const { return 1 << 20; }
};

// Whether what was being written may last or not, which the next board or the next append finds out.
inline bool leaves_in_doubt(const Failure& failure) {
  return failure.symbol == "unavailable" || failure.symbol == "deposed";
}

}  // namespace pizarra::journal
