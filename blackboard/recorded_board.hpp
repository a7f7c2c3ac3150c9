#pragma once

// The wall that remembers: a journal played back to one revision. It can be asked; whoever watches sees what held and
// then waits; what would change it fails with `read-only`.
//
//   Result<std::unique_ptr<RecordedBoard>> board = RecordedBoard::open(text, 120);
//   Result<Answers> towers = co_await (*board)->ask(query);

#include <limits>
#include <memory>
#include <string_view>

#include "blackboard/board.hpp"

namespace pizarra {

class Store;

class RecordedBoard : public Board {
 public:
  // The journal's text up to a revision: failure bad-journal.
  static Result<std::unique_ptr<RecordedBoard>> open(std::string_view journal,
                                                     Revision last = std::numeric_limits<Revision>::max());
  ~RecordedBoard() override;

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
  explicit RecordedBoard(std::unique_ptr<Store> store);
  const std::unique_ptr<Store> store_;
};

}  // namespace pizarra
