#pragma once

// The wall that remembers: a journal played back. It can be asked and watched; it goes on when it is stepped, and what
// would change it fails with `read-only`.
//
//   Result<std::unique_ptr<RecordedBoard>> board = RecordedBoard::open(executor, "cell.journal", {.revision = 120});
//   Result<Answers> towers = co_await (*board)->ask(query);
//   (*board)->step();                          // revision 121: whoever watches sees what it changed
//
// It only goes forward: what was before is another board.

#include <memory>
#include <optional>
#include <string>

#include "blackboard/journal/journal_file.hpp"
#include "blackboard/memory/memory_board.hpp"

namespace pizarra::memory {

class RecordedBoard : public Board {
 public:
  // As of a moment. Failures bad-journal, journal-file, forgotten.
  static Result<std::unique_ptr<RecordedBoard>> open(Executor& executor, const std::string& path,
                                                     const Moment& until = {});
  // From a store into which a journal was read already, from a file or from a log in etcd. What a log lacks is asked
  // about in vain: failure gap.
  static std::unique_ptr<RecordedBoard> of(Executor& executor, std::unique_ptr<store::Store> store,
                                           journal::PlayedBack played);
  ~RecordedBoard() override;

  Revision revision() const;
  // With the time of the last revision that was stepped to, or opened at.
  journal::LineStart moment() const { return {revision(), when_}; }
  // When the next revision was committed: nothing at the end.
  std::optional<Time> next() const;
  // Plays the next revision back: false at the end.
  Result<bool> step();

  // Declaring what the journal declares is harmless here, too.
  Task<Result<void>> declare(std::vector<Relation> relations) override;
  Task<Result<Revision>> transact(Transaction transaction) override;
  Task<Result<Answers>> ask(Query query) override;
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override;
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override;
  Task<Result<LeaseId>> lease(Duration length) override;
  Task<Result<void>> renew(LeaseId lease) override;
  Task<Result<void>> release(LeaseId lease) override;

 private:
  RecordedBoard(Executor& executor, std::unique_ptr<store::Store> store, journal::PlayedBack played);
  std::optional<std::string_view> next_line() const;

  store::Store& store_;
  const std::optional<Failure> lacks_;
  MemoryBoard board_;
  const std::unique_ptr<Board> view_;
  const std::string lines_;  // what is not played back yet, from at_ on
  std::size_t at_ = 0;
  Time when_{};
};

}  // namespace pizarra::memory
