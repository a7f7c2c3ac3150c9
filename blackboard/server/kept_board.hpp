#pragma once

// A board that lives again from its journal, where there is one, and goes on writing it: what a program serves.
//
//   const Time first = first_moment(wall_clock, "cell.journal");            // before its executor is made
//   KeptBoard kept(executor);
//   Result<void> begun = kept.begin(file);                                  // a null file: it keeps none
//   options.journal = kept.journal();
//   options.remembered = kept.take_remembered();
//   BoardServer::open(executor, kept.board(), options);

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/journal/journal_writer.hpp"
#include "blackboard/memory/memory_board.hpp"

namespace pizarra::server {

class KeptBoard {
 public:
  // `on_journal` is told when the journal cannot be written, and nothing when it can again.
  using OnJournal = std::function<void(const std::optional<Failure>&)>;

  explicit KeptBoard(Executor& executor, OnJournal on_journal = {})
      : executor_(executor), on_journal_(std::move(on_journal)) {}

  // Failures of JournalFile::recover.
  Result<void> begin(const std::shared_ptr<journal::JournalFile>& file);
  // Goes on from what was followed of a log that other boards share; only what is durable goes there, and everything to
  // `all`. The store has given out no lease, and gives out from `first_lease` on.
  void lead(std::unique_ptr<store::Store> store, LeaseId first_lease, std::vector<journal::RememberedReply> remembered,
            const std::shared_ptr<journal::Log>& log, store::JournalSink all = {});
  memory::MemoryBoard& board() { return *board_; }
  // Null where it keeps none.
  journal::JournalWriter* journal() { return journal_.get(); }
  std::vector<journal::RememberedReply> take_remembered() { return std::exchange(remembered_, {}); }

 private:
  Result<void> recover(const std::shared_ptr<journal::JournalFile>& file, store::Store& store);

  Executor& executor_;
  const OnJournal on_journal_;
  std::vector<journal::RememberedReply> remembered_;
  std::unique_ptr<journal::JournalWriter> journal_;
  std::unique_ptr<memory::MemoryBoard> board_;
};

// The wall clock's, unless that was set back since the journal's end: a board's times only grow, from life to life, and
// so do its leases' numbers. The wall clock is read last, because an executor's goes on from there.
Time first_moment(const std::function<Time()>& wall_clock, const std::string& journal,
                  journal::Disk& disk = journal::this_disk());

}  // namespace pizarra::server
