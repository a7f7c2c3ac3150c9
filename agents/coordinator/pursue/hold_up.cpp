#include "agents/coordinator/pursue/hold_up.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/coordinator/act/arm.hpp"
#include "agents/coordinator/retried_commit.hpp"
#include "agents/runtime/stop_fact.hpp"

namespace pizarra::coordinator {

namespace {

constexpr Duration first_pause = 1s;
constexpr Duration longest_pause = 8s;
constexpr Duration look_pause = 250ms;
constexpr Duration patience = std::chrono::minutes(10);

constexpr const char* stopped_by_somebody = "halted";

}  // namespace

bool is_hold_up(const Failure& failure) {
  constexpr std::string_view symbols[] = {stopped_by_somebody, "not-in-control", "not-commander", "journal-full",
                                          "disconnected",      "fault",          "timeout",       "busy"};
  return met_silence(failure) || std::ranges::find(symbols, failure.symbol) != std::end(symbols);
}

void HoldUp::went_on() {
  told_.clear();
  since_.reset();
  pause_ = {};
}

Task<Result<void>> HoldUp::await_end(Failure why) {
  const Time now = context_.executor.now();
  if (!since_) since_ = now;
  const bool is_stop = why.symbol == stopped_by_somebody;
  if (is_stop) since_ = now;
  if (now - *since_ > patience) co_return fail(why);
  if (told_ != why.sentence) {
    told_ = why.sentence;
    const std::string sentence = fmt::format("held up: {}; the goal goes on when that is over", why.sentence);
    co_await story_.tell("agent", sentence, failure_to_datum(why));
  }
  if (is_stop) co_await await_no_stop();
  pause_ = std::clamp(2 * pause_, first_pause, longest_pause);
  co_await pause(pause_);
  if (interruption_.raised()) co_return interruption_.failure();
  co_return Result<void>();
}

Task<void> HoldUp::await_no_stop() {
  const Datum pattern = runtime::any_stop();
  pause_ = {};
  while (!interruption_.raised()) {
    const std::vector<Fact> stops = co_await facts_now(context_.board, context_.executor, pattern);
    if (stops.empty()) co_return;
    co_await sleep(context_.executor, look_pause);
  }
}

Task<void> HoldUp::pause(Duration length) {
  const Time until = context_.executor.now() + length;
  while (context_.executor.now() < until && !interruption_.raised()) {
    co_await sleep(context_.executor, look_pause);
  }
}

}  // namespace pizarra::coordinator
