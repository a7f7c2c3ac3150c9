#pragma once

// A board between the eyes and their session on which two objects change names for a while: each look says of the one
// what was seen of the other, in its text and in its list.
//
//   ExchangedNames names{.until = time.now() + 2s, .one = "circle", .other = "cross"};     // until then
//   MistakenEyes board(*session, time, names);

#include <string>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::chaos {

struct ExchangedNames {
  Time until{};
  std::string one = {};
  std::string other = {};
};

class MistakenEyes : public Board {
 public:
  // All outlive it.
  MistakenEyes(Board& board, const Executor& time, const ExchangedNames& names)
      : board_(board), time_(time), names_(names) {}

  Task<Result<void>> declare(std::vector<Relation> relations) override { return board_.declare(std::move(relations)); }
  Task<Result<Revision>> transact(Transaction transaction) override;
  Task<Result<Answers>> ask(Query query) override { return board_.ask(std::move(query)); }
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override { return board_.watch(std::move(query)); }
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override {
    return board_.take(std::move(pattern), holder);
  }
  Task<Result<LeaseId>> lease(Duration length) override { return board_.lease(length); }
  Task<Result<void>> renew(LeaseId lease) override { return board_.renew(lease); }
  Task<Result<void>> release(LeaseId lease) override { return board_.release(lease); }

 private:
  Board& board_;
  const Executor& time_;
  const ExchangedNames& names_;
};

}  // namespace pizarra::chaos
