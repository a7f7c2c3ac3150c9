#pragma once

// A waiting place for coroutines that wait for an event, not for a time.
//
//   Event woken(executor);        // a latch that wakes every waiter once set; stays set until reset
//   Queue<Message> inbox(executor, 64);
//   std::optional<Message> next = co_await inbox.pop(deadline);     // empty after the deadline
//
// Waiters are resumed through Executor::post, never from inside set() or push(), so that nobody is re-entered.

#include <cassert>
#include <coroutine>
#include <deque>
#include <optional>
#include <vector>

#include "blackboard/time/executor.hpp"

namespace pizarra {

// A place where coroutines wait. Waiting ends with true when woken, with false at the deadline.
class WaitList {
 public:
  explicit WaitList(Executor& executor) : executor_(executor) {}
  WaitList(const WaitList&) = delete;
  WaitList& operator=(const WaitList&) = delete;
  ~WaitList() { assert(waiters_.empty()); }

  class Wait {
   public:
    Wait(WaitList& list, std::optional<Time> deadline) : list_(list), deadline_(deadline) {}
    Wait(const Wait&) = delete;
    Wait& operator=(const Wait&) = delete;
    ~Wait();
    bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<> waiter);
    bool await_resume() const noexcept { return woken_; }

   private:
    friend class WaitList;
    void finish(bool woken);
    WaitList& list_;
    std::optional<Time> deadline_;
    std::coroutine_handle<> waiter_;
    Executor::TimerId timer_ = 0;
    bool waiting_ = false;
    bool woken_ = false;
  };

  Wait wait(std::optional<Time> deadline = {}) { return {*this, deadline}; }
  void wake_one();
  void wake_all();

 private:
  Executor& executor_;
  std::deque<Wait*> waiters_;
};

class Event {
 public:
  explicit Event(Executor& executor) : waiters_(executor) {}
  bool is_set() const { return set_; }
  void set();
  void reset() { set_ = false; }
  // True when it was set in time.
  Task<bool> wait(std::optional<Time> deadline = {});

 private:
  bool set_ = false;
  WaitList waiters_;
};

template <class T>
class Queue {
 public:
  Queue(Executor& executor, std::size_t bound) : bound_(bound), waiters_(executor) {}
  // False, and nothing queued, when it is full.
  bool push(T item) {
    if (items_.size() >= bound_) return false;
    items_.push_back(std::move(item));
    waiters_.wake_one();
    return true;
  }
  std::size_t size() const { return items_.size(); }
  void clear() { items_.clear(); }
  Task<std::optional<T>> pop(std::optional<Time> deadline = {}) {
    while (items_.empty()) {
      const bool woken = co_await waiters_.wait(deadline);
      if (!woken) co_return std::nullopt;
    }
    std::optional<T> item = std::move(items_.front());
    items_.pop_front();
    co_return item;
  }

 private:
  std::size_t bound_;
  std::deque<T> items_;
  WaitList waiters_;
};

}  // namespace pizarra
