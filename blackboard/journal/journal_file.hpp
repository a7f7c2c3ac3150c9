#pragma once

// A journal kept in an SQLite file, for a board that is to live again: what stood at some revision, the horizon, and
// the journal's lines since. Both are checked against damage when they are read, and so is that the end is there
// (kept_mark.hpp).
//
//   Store store;
//   Result<std::shared_ptr<JournalFile>> file = JournalFile::open("cell.journal", {});
//   Result<std::vector<RememberedReply>> replies = (*file)->recover(store);     // before anything is appended
//   (*file)->append({lines, replies, true});           // it survives kill -9 and a power cut when this returns
//   while (*(*file)->compact(now) > 0) {}              // moves the horizon on, a slice at a time
//
// The past is kept as history says while there is space for it; where space is scarce, compaction lets it go.
// One board at a time has the file; others may read it meanwhile, with read_journal(). Calls may come from any thread,
// one after another. Failures: journal-full (no space; or the disk cannot be written; or the file was moved or removed;
// or SQLite's log was, or was cut short; this is checked before each group). bad-journal (damaged, or no journal at
// all). journal-file (everything else that the operating system or SQLite refuses).

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/journal/kept_mark.hpp"
#include "blackboard/journal/log.hpp"
#include "blackboard/journal/open_file.hpp"
#include "blackboard/journal/space_reserve.hpp"
#include "blackboard/journal/sqlite.hpp"

namespace pizarra::journal {

// How much of the past the horizon leaves to be asked about: at least that much, but no more bytes, once they are older
// than the replies that are remembered.
struct History {
  std::uint64_t revisions = 200'000;
  std::optional<Duration> time = {};  // in place of the revisions
  std::size_t bytes = std::size_t{1} << 30;
};

class JournalFile : public Log {
 public:
  // The rows that compaction takes in one slice, so that a board's next acknowledgement need not wait for more.
  static constexpr std::size_t largest_slice = 256 << 10;

  // The disk outlives it.
  static Result<std::shared_ptr<JournalFile>> open(const std::string& path, const History& history,
                                                   Disk& disk = this_disk());
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;
  ~JournalFile() override;

  const std::string& path() const override { return path_; }
  Result<std::vector<RememberedReply>> recover(store::Store& store) override;
  // Begins a new file with the durable facts of a store, as of `end`. To be called once, before anything is appended.
  Result<void> begin_with(const store::Store& store, const LineStart& end);
  Result<void> append(const JournalGroup& group, bool may_spend) override;
  Result<void> append(const JournalGroup& group) { return append(group, true); }
  JournalRoom room() override;
  Result<std::size_t> compact(Time now) override;
  Result<PlayedBack> read(store::Store& store, const Moment& until) const override;

 private:
  JournalFile(Disk& disk, std::string path, History history, std::unique_ptr<Disk::Lock> lock,
              sqlite::Database database);
  Result<void> check_place() const;
  Result<void> write(const JournalGroup& group);
  Result<std::size_t> compact_slice(Time now);
  bool spend_if_full(const Failure& failure);
  void copy_log_at(std::int64_t bytes);
  void give_log_back();

  Disk& disk_;
  const std::string path_;
  const History history_;
  std::mutex mutex_;
  const std::unique_ptr<Disk::Lock>
      lock_;  // closed after the database, because closing a file gives up SQLite's own locks on it
  SpaceReserve reserve_;
  KeptMark mark_;
  sqlite::Database database_;
  sqlite::Statement insert_;
  const OpenFile place_;
  const OpenFile log_place_;
  std::int64_t log_bytes_ = 0;  // when it was last written
  std::int64_t next_group_ = 1;
  bool waits_for_disk_ = true;
  bool spent_ = false;  // what was set aside, since room() was called
  std::int64_t log_pages_ = 0;
  std::size_t past_bytes_ = 0;  // of the groups in the log
  JournalRoom room_;
  std::size_t slice_bytes_ = largest_slice;
};

// Also removes the files that SQLite and the board leave beside it when they are killed.
void remove_journal(const std::string& path, Disk& disk = this_disk());

// Where a journal ends. Failures as above.
Result<LineStart> end_of_journal(const std::string& path, Disk& disk = this_disk());

// The journal of a file as of a moment, whether a board has it or not, and whether it is SQLite or, on this machine's
// disk, text: into an empty store. Failure `forgotten` when compaction has let that moment go, `not-yet` when there is
// no such revision.
Result<PlayedBack> read_journal(const std::string& path, store::Store& store, const Moment& until = {},
                                Disk& disk = this_disk());

}  // namespace pizarra::journal
