#include "agents/console/page_beat.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/runtime/follow.hpp"

namespace pizarra::console {

PageBeat::PageBeat(PageBoard& board, PageVoice& voice)
    : board_(board),
      voice_(voice),
      hands_changed_(board.executor()),
      following_(board.executor().spawn(follow_hands())) {}

void PageBeat::start() { beating_ = board_.executor().spawn(keep_beating()); }

void PageBeat::stamp(const Datum& form) { pulse_.came_back(form[1].integer(), board_.executor().now()); }

Task<void> PageBeat::keep_beating() {
  while (true) {
    if (voice_.is_free()) {
      const std::optional<Duration> measured = pulse_.round_trip();
      voice_.say(fmt::format("{{\"pulse\":{},\"deadline\":{:.0f},\"rtt\":{:.1f}}}",
                             pulse_.beat(board_.executor().now()), milliseconds(pulse_.deadline()),
                             measured ? milliseconds(*measured) : -1.0));
    }
    const Time next = board_.executor().now() + (in_hand_ ? Pulse::quick : Pulse::slow);
    co_await hands_changed_.wait(next);
  }
}

Task<void> PageBeat::follow_hands() {
  const Datum ours = list("commander"_sym, "?robot"_sym, board_.client());
  std::size_t arms = 0;
  const auto take = [this, &arms](Change change) -> Task<void> {
    if (change.resynchronised) arms = 0;
    arms = arms + change.added.size() - std::min(arms + change.added.size(), change.removed.size());
    in_hand_ = arms > 0;
    hands_changed_.wake_all();
    co_return;
  };
  co_await runtime::follow(board_.context(), ours, take);
}

}  // namespace pizarra::console
