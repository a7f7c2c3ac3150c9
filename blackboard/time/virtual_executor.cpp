#include "blackboard/time/virtual_executor.hpp"

#include <algorithm>
#include <cassert>

namespace pizarra {

void VirtualExecutor::post(Callback callback) { call_at(now_, std::move(callback)); }

Executor::TimerId VirtualExecutor::call_at(Time when, Callback callback) {
  const TimerId timer = next_timer_++;
  const Time due = std::max(when, now_);
  due_.emplace(std::pair(due, timer), std::move(callback));
  times_.emplace(timer, due);
  return timer;
}

void VirtualExecutor::cancel(TimerId timer) {
  const auto found = times_.find(timer);
  if (found == times_.end()) return;
  // The callback is destroyed last, because what it owns may cancel timers in turn.
  const auto node = due_.extract(std::pair(found->second, timer));
  times_.erase(found);
}

void VirtualExecutor::watch_readable(int, std::function<void()>) {
  assert(false && "files have no place in virtual time");
  std::terminate();
}

void VirtualExecutor::unwatch_readable(int) {}

Task<void> VirtualExecutor::offload(std::function<void(const std::function<bool()>&)> work, Duration virtual_cost) {
  const std::function<bool()> never = [] { return false; };
  work(never);
  co_await sleep(*this, virtual_cost);
}

void VirtualExecutor::run_next() {
  auto node = due_.extract(due_.begin());
  now_ = node.key().first;
  times_.erase(node.key().second);
  node.mapped()();
}

void VirtualExecutor::run_until(std::function<bool()> finished) {
  while (!stopped_ && !finished() && !due_.empty()) run_next();
  stopped_ = false;
}

void VirtualExecutor::run_for(Duration duration) {
  const Time end = now_ + duration;
  while (!stopped_ && !due_.empty() && due_.begin()->first.first <= end) run_next();
  if (!stopped_) now_ = end;
  stopped_ = false;
}

}  // namespace pizarra
