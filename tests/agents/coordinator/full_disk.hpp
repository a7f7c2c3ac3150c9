#pragma once

// A board as an agent sees it whose journal's disk is full at times: what touches a durable relation is refused then,
// and everything else goes on.
//
//   bool disk_full = false;
//   FullDisk view(board, "coordinator", disk_full);

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra {

class FullDisk : public Board {
 public:
  FullDisk(MemoryBoard& board, std::string teller, const bool& full)
      : board_(board), view_(board.view(std::move(teller))), full_(full) {}

  Task<Result<void>> declare(std::vector<Relation> relations) override { return view_->declare(std::move(relations)); }
  Task<Result<Revision>> transact(Transaction transaction) override {
    if (full_ && touches_durable(transaction)) return refuse();
    return view_->transact(std::move(transaction));
  }
  Task<Result<Answers>> ask(Query query) override { return view_->ask(std::move(query)); }
  Task<Result<std::unique_ptr<Watch>>> watch(Query query) override { return view_->watch(std::move(query)); }
  Task<Result<std::optional<Fact>>> take(Datum pattern, LeaseId holder) override {
    return view_->take(std::move(pattern), holder);
  }
  Task<Result<LeaseId>> lease(Duration length) override { return view_->lease(length); }
  Task<Result<void>> renew(LeaseId lease) override { return view_->renew(lease); }
  Task<Result<void>> release(LeaseId lease) override { return view_->release(lease); }

 private:
  static Task<Result<Revision>> refuse() { co_return fail("journal-full", "the disk is full"); }

  bool is_durable(const Datum& pattern) const {
    const auto table = board_.store().tables().find(pattern.head());
    return table != board_.store().tables().end() && table->second.relation().durable;
  }
  bool touches_durable(const Transaction& transaction) const {
    for (const Transaction::Step& step : transaction.steps) {
      const auto* tell = std::get_if<Transaction::Tell>(&step);
      const auto* retract = std::get_if<Transaction::Retract>(&step);
      if (tell && is_durable(tell->fact)) return true;
      if (retract && is_durable(retract->pattern)) return true;
    }
    return false;
  }

  MemoryBoard& board_;
  std::unique_ptr<Board> view_;
  const bool& full_;
};

}  // namespace pizarra
