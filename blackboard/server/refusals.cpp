#include "blackboard/server/refusals.hpp"

#include <utility>

#include "blackboard/relation.hpp"
#include "lisp/shortened.hpp"

namespace pizarra {

Result<void> Refusals::declare(MemoryBoard& board) {
  const Relation relation{.name = "board-refusal",
                          .arguments = {{"client", ArgumentType::string},
                                        {"symbol", ArgumentType::symbol},
                                        {"count", ArgumentType::integer},
                                        {"sentence", ArgumentType::string}},
                          .key = {0, 1},
                          .durable = false,
                          .lease = {}};
  return board.declare("board", {relation});
}

Refusals::~Refusals() {
  if (timer_ != 0) board_.executor().cancel(timer_);
}

void Refusals::note(const std::string& client, const Failure& failure) {
  Kind kind{client, failure.symbol};
  if (!counts_.contains(kind) && counts_.size() >= most_kinds) kind = {"others", "refused"};
  Count& count = counts_[kind];
  ++count.count;
  count.sentence = shortened(failure.sentence, longest_sentence);
  untold_.insert(std::move(kind));
  if (timer_ != 0) return;
  timer_ = board_.executor().call_at(board_.executor().now() + pause, [this] {
    timer_ = 0;
    tell();
  });
}

void Refusals::tell() {
  Transaction transaction;
  for (const Kind& kind : std::exchange(untold_, {})) {
    const Count& count = counts_[kind];
    transaction.tell(list("board-refusal"_sym, kind.first, Datum::symbol(kind.second), count.count, count.sentence));
  }
  // A board that takes no more facts has nobody to tell it to.
  [[maybe_unused]] const Result<Revision> told = board_.transact("board", transaction);
}

}  // namespace pizarra
