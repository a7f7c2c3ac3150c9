#include "blackboard/server/refusals.hpp"

#include <algorithm>
#include <utility>

#include "blackboard/relation.hpp"
#include "lisp/shortened.hpp"

namespace pizarra::server {

Result<void> Refusals::declare(memory::MemoryBoard& board) {
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
  if (!counts_.contains(kind) && counts_.size() >= most_kinds) forget_the_oldest();
  Count& count = counts_[kind];
  ++count.count;
  count.newest = ++noted_;
  count.sentence = shortened(failure.sentence, longest_sentence);
  untold_.insert(std::move(kind));
  if (timer_ != 0) return;
  timer_ = board_.executor().call_at(board_.executor().now() + pause, [this] {
    timer_ = 0;
    tell();
  });
}

void Refusals::forget_the_oldest() {
  const auto oldest = std::ranges::min_element(counts_, {}, [](const auto& entry) { return entry.second.newest; });
  others_.count += oldest->second.count;
  others_.sentence = std::move(oldest->second.sentence);
  untold_.erase(oldest->first);
  counts_.erase(oldest);
}

void Refusals::tell() {
  Transaction transaction;
  const auto say = [&](const Kind& kind, const Count& count) {
    transaction.tell(list("board-refusal"_sym, kind.first, Datum::symbol(kind.second), count.count, count.sentence));
  };
  for (const Kind& kind : told_) {
    if (counts_.contains(kind)) continue;
    transaction.retract(list("board-refusal"_sym, kind.first, Datum::symbol(kind.second), "?"_sym, "?"_sym));
  }
  std::erase_if(told_, [&](const Kind& kind) { return !counts_.contains(kind); });
  for (const Kind& kind : untold_) say(kind, counts_[kind]);
  told_.merge(untold_);
  untold_.clear();
  if (others_.count > 0) say({"others", "refused"}, others_);
  // A board that takes no more facts has nobody to tell it to.
  [[maybe_unused]] const Result<Revision> told = board_.transact("board", transaction);
}

}  // namespace pizarra::server
