#pragma once

// Writes a board's journal while the board goes on: what is told while one group is written becomes the next group, so
// that one wait for the disk serves many.
//
//   JournalWriter writer(executor, log);
//   board.set_journal([&](std::string_view line) { writer.append(line); });
//   writer.on_progress = [&] { answer whoever waits for a position up to writer.kept(); };
//   writer.keep();                        // everything so far, soon; otherwise within 100 ms, and not waited for
//
// Those who are acknowledged together come again together: a group waits for as many as wait for an answer, an eighth
// of what the disk took lately at most. No more should wait to be written than the file has set space aside for, which
// check_room() says. When the disk is full, the space is used for what waits, and writer.failure() says so until there
// is space again: what adds to durable relations should be refused meanwhile, and what only takes from them while
// check_room() says so. The past is let go then. Groups that cannot be written even so are tried again four times a
// second. Destroying it writes what is left.

#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "blackboard/journal/log.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::journal {

class JournalWriter {
 public:
  using Position = std::uint64_t;  // how many lines came before, and this one
  // What need not last; what must; and of that, what takes facts away and adds none.
  enum class Change : std::uint8_t { passing, lasting, removing };
  // The most that waits of `passing` changes.
  static constexpr std::size_t max_waiting_bytes = 16 << 20;

  JournalWriter(Executor& executor, std::shared_ptr<Log> log);
  JournalWriter(const JournalWriter&) = delete;
  JournalWriter& operator=(const JournalWriter&) = delete;
  ~JournalWriter();

  // Called when kept() may have grown, or something could not be written.
  std::function<void()> on_progress;
  // Called when failure() comes, and when it goes.
  std::function<void(const std::optional<Failure>&)> on_failure;

  void append(std::string_view line);
  // With the lines appended last, or, if those changed nothing, not at all.
  void remember(const RememberedReply& reply);
  // Once for each who waits for an answer.
  void keep();
  Position position() const { return position_; }
  Position kept() const { return kept_; }
  // Why nothing more can be added, since when durable changes should be refused.
  const std::optional<Failure>& failure() const { return failure_; }
  // Whether what was appended already cannot be written either.
  bool stuck() const { return stuck_; }
  // Whether so much more may be appended: a failure, or so much that waits for a slow disk.
  Result<void> check_room(Change change, std::size_t bytes) const;
  const std::shared_ptr<Log>& log() const { return log_; }

 private:
  struct Pending {
    JournalGroup group;
    Position last = 0;
    std::size_t waiting = 0;  // for an answer
    ReplyLines replies = {};
  };
  // What a worker does away from the board's thread; it outlives the writer if need be.
  struct Work {
    std::shared_ptr<Log> log;
    Pending what;
    bool may_spend = true;
    Result<void> written = {};
    JournalRoom room;
    std::atomic<bool> ended = false;

    void write();
  };
  Task<void> write_groups();
  Task<void> write_group();
  Task<void> compact();
  std::optional<Time> look_again() const;
  void take_pending();
  void wait_for_company();
  void write_at(Time when);
  bool durable_waits() const;
  std::size_t waiting() const;
  std::size_t waiting_bytes() const;
  std::size_t most_passing() const;
  void finish();
  std::optional<Failure> lack_of_room() const;

  Executor& executor_;
  const std::shared_ptr<Log> log_;
  std::deque<Pending> pending_;  // each written at once
  Position position_ = 0;
  Position kept_ = 0;
  std::shared_ptr<Work> work_;  // under way, or to be tried again
  bool is_writing_ = false;
  JournalRoom room_;
  std::size_t written_bytes_ = 0;  // that compaction has to make up for
  Duration disk_takes_{};          // to make a group durable, lately
  std::size_t company_ = 0;        // how many waited for an answer when the last group was written
  std::optional<Failure> failure_;
  bool stuck_ = false;
  Event due_;
  Executor::TimerId timer_ = 0;
  Job job_;
};

}  // namespace pizarra::journal
