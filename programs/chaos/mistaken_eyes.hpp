#pragma once

// A board between the eyes and their session on which looks are mistaken. Two objects change names for a while: each
// look says of the one what was seen of the other, in its text and in its list. Or a few looks tell of an object that
// is not seen, as if it stood beside one that is.
//
//   Mistakes mistakes;
//   mistakes.names = {.until = time.now() + 2s, .one = "circle", .other = "cross"};                   // until then
//   mistakes.invented = {.object = "square", .beside = "cross", .aside_px = 50, .looks_left = 2};
//   MistakenEyes board(*session, time, mistakes);

#include <string>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::chaos {

struct ExchangedNames {
  Time until{};
  std::string one = {};
  std::string other = {};
};

// Looks that show the one and not the other are used up.
struct InventedSighting {
  std::string object = {};
  std::string beside = {};
  double aside_px = 0;
  int looks_left = 0;
};

struct Mistakes {
  ExchangedNames names;
  InventedSighting invented;
};

class MistakenEyes : public Board {
 public:
  // All outlive it.
  MistakenEyes(Board& board, const Executor& time, Mistakes& mistakes)
      : board_(board), time_(time), mistakes_(mistakes) {}

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
  void mistake(Datum& look);

  Board& board_;
  const Executor& time_;
  Mistakes& mistakes_;
};

}  // namespace pizarra::chaos
