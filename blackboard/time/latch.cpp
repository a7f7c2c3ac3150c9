#include "blackboard/time/latch.hpp"

#include <algorithm>

namespace pizarra {

WaitList::Wait::~Wait() {
  if (timer_ != 0) list_.executor_.cancel(timer_);
  if (waiting_) std::erase(list_.waiters_, this);
  // Woken but never resumed: the next in line must have its chance.
  if (woken_ && waiter_) list_.wake_one();
}

void WaitList::Wait::await_suspend(std::coroutine_handle<> waiter) {
  waiter_ = waiter;
  waiting_ = true;
  list_.waiters_.push_back(this);
  if (deadline_) {
    timer_ = list_.executor_.call_at(*deadline_, [this] {
      timer_ = 0;
      std::erase(list_.waiters_, this);
      finish(false);
    });
  }
}

void WaitList::Wait::finish(bool woken) {
  waiting_ = false;
  woken_ = woken;
  if (timer_ != 0) list_.executor_.cancel(timer_);
  // A timer that was due long ago comes after all that is due already, as one that is due now does: without a look at
  // the clock.
  timer_ = list_.executor_.call_at(Time(), [this] {
    timer_ = 0;
    std::exchange(waiter_, nullptr).resume();
  });
}

void WaitList::wake_one() {
  if (waiters_.empty()) return;
  Wait* first = waiters_.front();
  waiters_.pop_front();
  first->finish(true);
}

void WaitList::wake_all() {
  while (!waiters_.empty()) wake_one();
}

void Event::set() {
  set_ = true;
  waiters_.wake_all();
}

Task<bool> Event::wait(std::optional<Time> deadline) {
  if (set_) co_return true;
  const bool woken = co_await waiters_.wait(deadline);
  co_return woken;
}

}  // namespace pizarra
