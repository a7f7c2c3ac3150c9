// When a client's turn comes, and when it comes no more.

#include <fmt/format.h>

#include "agents/vision/agent/vision_state.hpp"

namespace pizarra::vision {
namespace {

// For others; a learning takes two seconds.
constexpr Duration longest_wait_for_turn = 6s;

}  // namespace

VisionAgent::State::Turn::~Turn() {
  state.turns.leave(number, state.context.executor.now());
  state.turns_changed.wake_all();
}

Task<Result<std::unique_ptr<VisionAgent::State::Turn>>> VisionAgent::State::take_turn(std::string client,
                                                                                      TurnQueue::Kind kind) {
  const Result<int> number = turns.enter(client, kind, context.executor.now());
  if (!number) co_return fail(number);
  auto turn = std::make_unique<Turn>(*this, *number, kind, client);
  const Result<bool> begun = begin_turn(*turn);
  if (!begun) co_return fail(begun);
  if (*begun) co_return turn;
  // Others may have had to make room.
  turns_changed.wake_all();
  const Result<bool> present_before = co_await is_present(client);
  const Result<void> came = co_await wait_for_turn(*turn);
  if (!came) co_return fail(came);
  const Result<bool> present = co_await is_present(client);
  const bool died = present_before.value_or(false) && !present.value_or(true);
  if (died) co_return fail("absent", "the client that asked is gone", Datum::symbol(client));
  co_return turn;
}

Result<bool> VisionAgent::State::begin_turn(const Turn& turn) {
  if (!turns.waits(turn.number)) {
    return fail("busy", fmt::format("{} asks for so much that this made room for others", turn.client),
                Datum::symbol(turn.client));
  }
  const std::string tracking_for = holders.tracker();
  const bool excluded = turn.kind == TurnQueue::Kind::learning && !tracking_for.empty();
  if (excluded && turns.is_first_of_its_client(turn.number)) {
    return fail("busy", fmt::format("vision is tracking for {}", tracking_for), Datum::symbol(tracking_for));
  }
  if (!turns.is_next(turn.number)) return false;
  turns.begin(turn.number);
  return true;
}

Task<Result<void>> VisionAgent::State::wait_for_turn(const Turn& turn) {
  bool in_time = true;
  while (in_time) {
    const Result<bool> begun = begin_turn(turn);
    if (!begun) co_return fail(begun);
    if (*begun) co_return {};
    std::optional<Time> deadline;
    const bool first = turns.is_first_of_its_client(turn.number);
    if (first) deadline = turns.first_since(turn.number) + longest_wait_for_turn;
    in_time = co_await turns_changed.wait(deadline);
  }
  const std::string served = turns.served();
  co_return fail("busy", fmt::format("vision is there for {} first, and no turn came in 6 s", served),
                 Datum::symbol(served));
}

Task<void> VisionAgent::State::let_tracking_look() {
  const Time deadline = context.executor.now() + longest_wait_for_turn;
  bool in_time = true;
  while (in_time) {
    if (tracker.empty() || !tracking_is_next) co_return;
    in_time = co_await turns_changed.wait(deadline);
  }
}

}  // namespace pizarra::vision
