#pragma once

// A board that hands on every call and keeps which relations were read, and which were told.

#include <set>
#include <string>

#include "blackboard/board.hpp"

namespace pizarra::programs {

class BoardTap : public Board {
 public:
  explicit BoardTap(std::unique_ptr<Board> board) : board_(std::move(board)) {}

  Task<Result<void>> declare(std::vector<Relation> relations) override { return board_->declare(std::move(relations)); }
  Task<Result<Revision>> transact(Transaction transaction) override;
  Task<Result<Answers>> ask(Query query) override;
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override;
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override;
  Task<Result<LeaseId>> lease(Duration length) override { return board_->lease(length); }
  Task<Result<void>> renew(LeaseId lease) override { return board_->renew(lease); }
  Task<Result<void>> release(LeaseId lease) override { return board_->release(lease); }

  std::set<std::string> read;  // asked for, watched, taken, or a precondition
  std::set<std::string> told;

 private:
  void note(const Query& query);

  std::unique_ptr<Board> board_;
};

}  // namespace pizarra::programs
