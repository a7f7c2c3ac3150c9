#pragma once

// A board that passes everything on to another: what a test makes different of it, it overrides.
//
//   class Deaf : public PassingBoard { ... Task<Result<Answers>> ask(Query) override; };

#include "blackboard/board.hpp"

namespace pizarra {

class PassingBoard : public Board {
 public:
  explicit PassingBoard(std::unique_ptr<Board> to) : to_(std::move(to)) {}

  Task<Result<void>> declare(std::vector<Relation> relations) override { return to_->declare(std::move(relations)); }
  Task<Result<Revision>> transact(Transaction transaction) override { return to_->transact(std::move(transaction)); }
  Task<Result<Answers>> ask(Query query) override { return to_->ask(std::move(query)); }
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override { return to_->watch(std::move(query)); }
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override {
    return to_->take(std::move(pattern), holder);
  }
  Task<Result<LeaseId>> lease(Duration length) override { return to_->lease(length); }
  Task<Result<void>> renew(LeaseId lease) override { return to_->renew(lease); }
  Task<Result<void>> release(LeaseId lease) override { return to_->release(lease); }

 private:
  const std::unique_ptr<Board> to_;
};

}  // namespace pizarra
