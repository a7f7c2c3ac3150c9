#include "agents/console/picture_keeper.hpp"

#include <algorithm>
#include <array>

#include "agents/runtime/declared.hpp"

namespace pizarra::console {

namespace {

constexpr std::array<std::string_view, 3> shown_kinds{"colour", "left", "annotated"};

}  // namespace

PictureKeeper::PictureKeeper(Setup setup) : setup_(std::move(setup)) {
  following_ = setup_.executor.spawn(follow_streams());
}

PictureKeeper::~PictureKeeper() = default;

Task<void> PictureKeeper::follow_streams() {
  const Datum pattern = list("stream"_sym, "?name"_sym, "?kind"_sym, "?place"_sym);
  const Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(*setup_.board, query_for(pattern));
  if (!watch) {
    say_trouble(watch.error());
    co_return;
  }
  while (true) {
    const Result<Change> change = co_await (*watch)->next();
    if (!change) co_return;
    for (const Answer& answer : change->added) {
      const Datum& fact = answer.facts.front().datum;
      if (std::ranges::count(shown_kinds, fact[2].text()) > 0) begin(std::string(fact[1].text()));
    }
  }
}

// A subscription follows its stream from one publisher to the next.
void PictureKeeper::begin(const std::string& stream) {
  if (kept_.contains(stream) || kept_.size() >= PictureStore::max_streams) return;
  Kept& kept = *kept_.emplace(stream, std::make_unique<Kept>()).first->second;
  kept.subscription =
      setup_.streams.subscribe(stream, [this, stream, &kept](const StreamFrame& frame) { take(stream, kept, frame); });
}

void PictureKeeper::take(const std::string& stream, Kept& kept, const StreamFrame& frame) {
  const Time now = setup_.executor.now();
  if (now < kept.last + interval || !kept.keeping.done()) return;
  kept.last = now;
  kept.keeping = setup_.executor.spawn(keep(stream, frame));
}

Task<void> PictureKeeper::keep(std::string stream, StreamFrame frame) {
  const Result<void> kept = co_await setup_.store.keep(std::move(stream), std::move(frame));
  if (kept) {
    troubled_ = false;
  } else {
    say_trouble(kept.error());
  }
}

void PictureKeeper::say_trouble(const Failure& failure) {
  if (!std::exchange(troubled_, true)) setup_.trouble(failure);
}

}  // namespace pizarra::console
