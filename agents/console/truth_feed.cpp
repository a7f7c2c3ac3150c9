#include "agents/console/truth_feed.hpp"

#include "blackboard/time/latch.hpp"

namespace pizarra::console {

TruthFeed::Look::~Look() { feed_.receivers_.erase(number_); }

std::unique_ptr<TruthFeed::Look> TruthFeed::look(Receiver receiver) {
  receivers_.emplace(next_, std::move(receiver));
  if (asking_.done()) asking_ = executor_.spawn(ask_on());
  return std::make_unique<Look>(*this, next_++);
}

// Who is told may end its look, or another's.
void TruthFeed::hand_out(const Result<Datum>& truth) {
  const std::map<std::uint64_t, Receiver> receivers = receivers_;
  for (const auto& [number, receive] : receivers) {
    if (receivers_.contains(number)) receive(truth);
  }
}

Task<void> TruthFeed::ask_on() {
  while (!receivers_.empty()) {
    const Result<Datum> truth = co_await ask_();
    hand_out(truth);
    co_await sleep(executor_, pause);
  }
}

}  // namespace pizarra::console
