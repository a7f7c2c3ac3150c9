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
  const Duration passed = shared_now() - begun_;
  const auto gained = static_cast<Duration::rep>(static_cast<double>(passed.count()) * clock_.drift);
  return shared_now() + clock_.ahead + Duration(gained);
}

Executor::TimerId Process::call_at(Time when, Callback callback) {
  const TimerId timer = next_++;
  Waiting& waiting = waiting_[timer];
  waiting.when = when;
  waiting.callback = std::move(callback);
  if (alive_) wait_for(timer, waiting);
  return timer;
}

void Process::wait_for(TimerId timer, Waiting& waiting) {
  const Duration left = std::max(waiting.when - now(), Duration::zero());
  // Rounded up, so that its own clock has come that far.
  const auto real = static_cast<Duration::rep>(static_cast<double>(left.count()) / (1 + clock_.drift));
  const Duration wait = left == Duration::zero() || clock_.drift == 0 ? left : Duration(real + 1);
  waiting.at = time_.call_at(time_.now() + wait, [this, timer] { become_due(timer); });
}

// The clock is another now than it was when they began to wait.
void Process::wait_anew() {
  if (!alive_) return;
  for (auto& [timer, waiting] : waiting_) {
    if (waiting.at == 0) continue;
    time_.cancel(waiting.at);
    wait_for(timer, waiting);
  }
}

void Process::jump(Duration ahead) {
  clock_.ahead += ahead;
  wait_anew();
}

void Process::suspend() {
  pause();
  suspended_since_ = time_.now();
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
  if (alive_ && steps_ >= held_step_ && when_held_) std::exchange(when_held_, nullptr)();
}

void Process::resume() {
  paused_ = false;
  if (suspended_since_) {
    const Time stood_at = now();
    suspended_since_.reset();
    clock_.ahead += stood_at - now();
    wait_anew();
  }
  for (const TimerId timer : std::exchange(held_up_, {})) {
    const auto found = waiting_.find(timer);
    if (found != waiting_.end()) wait_for(timer, found->second);
  }
}

void Process::kill_at(std::uint64_t steps, Callback then) {
  last_step_ = std::max(steps, steps_ + 1);
  then_ = std::move(then);
}

void Process::hold_at(std::uint64_t steps, Callback then) {
  held_step_ = steps;
  when_held_ = std::move(then);
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
