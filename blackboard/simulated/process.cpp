#include "blackboard/simulated/process.hpp"

#include <algorithm>
#include <cassert>
#include <exception>
#include <utility>

namespace pizarra::simulated {

Process::Process(Executor& time, Clock clock) : time_(time), clock_(clock), begun_(time.now()) {}

Process::~Process() {
  for (const auto& [timer, waiting] : waiting_) {
    if (waiting.at != 0) time_.cancel(waiting.at);
  }
}

Time Process::now() const {
  const Duration passed = time_.now() - begun_;
  const auto gained = static_cast<Duration::rep>(static_cast<double>(passed.count()) * clock_.drift);
  return time_.now() + clock_.ahead + Duration(gained);
}

Executor::TimerId Process::call_at(Time when, Callback callback) {
  const TimerId timer = next_++;
  const Duration left = std::max(when - now(), Duration::zero());
  // Rounded up, so that its own clock has come that far.
  const auto real = static_cast<Duration::rep>(static_cast<double>(left.count()) / (1 + clock_.drift));
  const Duration wait = left == Duration::zero() || clock_.drift == 0 ? left : Duration(real + 1);
  Waiting& waiting = waiting_[timer];
  waiting.callback = std::move(callback);
  if (alive_) waiting.at = time_.call_at(time_.now() + wait, [this, timer] { become_due(timer); });
  return timer;
}

void Process::cancel(TimerId timer) {
  // The callback is destroyed last, because what it owns may cancel timers in turn.
  const auto node = waiting_.extract(timer);
  if (!node.empty() && node.mapped().at != 0) time_.cancel(node.mapped().at);
}

void Process::become_due(TimerId timer) {
  const auto found = waiting_.find(timer);
  if (found == waiting_.end()) return;
  found->second.at = 0;
  if (!alive_) return;
  if (paused_) {
    held_up_.push_back(timer);
  } else {
    run(timer);
  }
}

void Process::run(TimerId timer) {
  auto node = waiting_.extract(timer);
  if (node.empty()) return;
  node.mapped().callback();
  if (++steps_ >= last_step_) kill();
}

void Process::resume() {
  paused_ = false;
  for (const TimerId timer : std::exchange(held_up_, {})) {
    const auto found = waiting_.find(timer);
    if (found == waiting_.end()) continue;
    found->second.at = time_.call_at(time_.now(), [this, timer] { become_due(timer); });
  }
}

void Process::kill_at(std::uint64_t steps, Callback then) {
  last_step_ = std::max(steps, steps_ + 1);
  then_ = std::move(then);
}

void Process::kill() {
  if (!std::exchange(alive_, false)) return;
  if (then_) time_.post(std::move(then_));
}

void Process::watch_readable(int, std::function<void()>) {
  assert(false && "files have no place in virtual time");
  std::terminate();
}

void Process::unwatch_readable(int) {}

Task<void> Process::offload(std::function<void(const std::function<bool()>&)> work, Duration virtual_cost) {
  const std::function<bool()> never = [] { return false; };
  spent_ = Duration::zero();
  work(never);
  const Duration took = virtual_cost + std::exchange(spent_, Duration::zero());
  co_await sleep(*this, took);
}

void Process::run_until(std::function<bool()>) {
  assert(false && "only who has the shared time runs it");
  std::terminate();
}

}  // namespace pizarra::simulated
