#include "agents/vision/agent/client_turns.hpp"

#include <fmt/format.h>

namespace pizarra::vision {

ClientTurns::Turn::~Turn() {
  turns_.queue_.leave(number_, turns_.context_.executor.now());
  turns_.wake();
}

Task<Result<std::unique_ptr<ClientTurns::Turn>>> ClientTurns::take(std::string client, TurnQueue::Kind kind) {
  const Result<int> number = queue_.enter(client, kind, context_.executor.now());
  if (!number) co_return fail(number);
  auto turn = std::make_unique<Turn>(*this, *number, kind, client);
  const Result<bool> begun = begin(*turn);
  if (!begun) co_return fail(begun);
  if (*begun) co_return turn;
  // Others may have had to make room.
  wake();
  const Result<bool> present_before = co_await presence_.is_present(client);
  const Result<void> came = co_await wait_for(*turn);
  if (!came) co_return fail(came);
  const Result<bool> present = co_await presence_.is_present(client);
  const bool died = present_before.value_or(false) && !present.value_or(true);
  if (died) co_return fail("absent", "the client that asked is gone", Datum::symbol(client));
  co_return turn;
}

Result<bool> ClientTurns::begin(const Turn& turn) {
  if (!queue_.waits(turn.number_)) {
    return fail("busy", fmt::format("{} has the most requests waiting: this one made room for others", turn.client_),
                Datum::symbol(turn.client_));
  }
  const std::string tracking_for = holders_.tracker();
  const bool excluded = turn.kind_ == TurnQueue::Kind::learning && !tracking_for.empty();
  if (excluded && queue_.is_first_of_its_client(turn.number_)) {
    return fail("busy", fmt::format("vision is tracking for {}", tracking_for), Datum::symbol(tracking_for));
  }
  if (!queue_.is_next(turn.number_)) return false;
  queue_.begin(turn.number_);
  return true;
}

Task<Result<void>> ClientTurns::wait_for(const Turn& turn) {
  bool in_time = true;
  while (in_time) {
    const Result<bool> begun = begin(turn);
    if (!begun) co_return fail(begun);
    if (*begun) co_return {};
    std::optional<Time> deadline;
    const bool first = queue_.is_first_of_its_client(turn.number_);
    if (first) deadline = queue_.first_since(turn.number_) + longest_wait;
    in_time = co_await changed_.wait(deadline);
  }
  const std::string served = queue_.served();
  co_return fail("busy", fmt::format("the eyes serve {} first, and no turn came within 6 s", served),
                 Datum::symbol(served));
}

}  // namespace pizarra::vision
