#pragma once

// A board as an agent sees it whose journal's disk has trouble at times: what touches a durable relation is refused
// while it is full, and stands but may not last while it fails. Everything else goes on.
//
//   Disk disk = Disk::sound;
//   TroubledDisk view(board, "coordinator", disk);

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/store/store.hpp"
#include "tests/blackboard/passing_board.hpp"

namespace pizarra {

enum class Disk : std::uint8_t { sound, full, failing };

class TroubledDisk : public PassingBoard {
 public:
  TroubledDisk(memory::MemoryBoard& board, std::string teller, const Disk& disk)
      : PassingBoard(board.view(std::move(teller))), board_(board), disk_(disk) {}

  Task<Result<Revision>> transact(Transaction transaction) override {
    const bool troubled = disk_ != Disk::sound && touches_durable(transaction);
    if (!troubled) co_return co_await PassingBoard::transact(std::move(transaction));
    if (disk_ == Disk::full) co_return fail("journal-full", "the disk is full");
    const Result<Revision> told = co_await PassingBoard::transact(std::move(transaction));
    if (!told) co_return told;
    co_return fail("not-durable", "the disk fails", to_datum(*told));
  }

 private:
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

  const memory::MemoryBoard& board_;
  const Disk& disk_;
};

}  // namespace pizarra
