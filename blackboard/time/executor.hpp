#pragma once

// One thread on which all agents of a process run: callbacks, timers, coroutines, files to poll, work to offload.
//
// There are two: RealExecutor (this machine's time) and VirtualExecutor (time jumps to the next timer; the same seed
// gives the same run). Agents see only this interface. Callbacks run in the order (time, registration).
//
//   VirtualExecutor executor;
//   Job job = executor.spawn(agent.run());
//   executor.run_until([&] { return job.done(); });

#include <functional>
#include <memory>

#include "blackboard/time/clock.hpp"
#include "blackboard/time/task.hpp"

namespace pizarra {

using Callback = std::move_only_function<void()>;

// A running task that nobody awaits. Destroying the Job cancels the task. It must not be destroyed from inside its own
// task. An exception that leaves the task is a bug and ends the program.
class [[nodiscard]] Job {
 public:
  Job();
  explicit Job(Task<void> task);
  Job(Job&&) noexcept;
  Job& operator=(Job&&) noexcept;
  ~Job();
  bool done() const;

 private:
  friend class Executor;
  struct State;
  std::shared_ptr<State> state_;
};

class Executor {
 public:
  using TimerId = std::uint64_t;

  virtual ~Executor() = default;

  virtual Time now() const = 0;
  // Runs `callback` soon, after what is due already. In real time other threads may call this and now(), no more.
  virtual void post(Callback callback) = 0;
  virtual TimerId call_at(Time when, Callback callback) = 0;
  // Unknown or finished timers are ignored.
  virtual void cancel(TimerId timer) = 0;
  // Calls back whenever the file can be read, until unwatched. Virtual time refuses it by assertion.
  virtual void watch_readable(int file, std::function<void()> callback) = 0;
  virtual void unwatch_readable(int file) = 0;
  // A long computation away from the agents' thread: in real time on one of a bounded number of worker threads
  // (worker_pool.hpp), in virtual time inline, finishing `virtual_cost` later. Destroying the task abandons the result;
  // `work` should look at `cancelled` now and then, and must own all it touches, because it may outlive the task.
  virtual Task<void> offload(std::function<void(const std::function<bool()>& cancelled)> work,
                             Duration virtual_cost) = 0;

  // Starts the task through post().
  Job spawn(Task<void> task);

  // Runs until `finished` answers true (asked before every callback), stop() was called (before it or meanwhile), or,
  // in virtual time, nothing is left to do.
  virtual void run_until(std::function<bool()> finished) = 0;
  virtual void stop() = 0;
};

// co_await sleep(executor, 100ms);
class Sleep {
 public:
  Sleep(Executor& executor, Duration duration) : executor_(executor), duration_(duration) {}
  Sleep(const Sleep&) = delete;
  Sleep& operator=(const Sleep&) = delete;
  ~Sleep() {
    if (timer_ != 0) executor_.cancel(timer_);
  }
  bool await_ready() const noexcept { return false; }
  void await_suspend(std::coroutine_handle<> waiter) {
    timer_ = executor_.call_at(executor_.now() + duration_, [this, waiter] {
      timer_ = 0;
      waiter.resume();
    });
  }
  void await_resume() const noexcept {}

 private:
  Executor& executor_;
  Duration duration_;
  Executor::TimerId timer_ = 0;
};

inline Sleep sleep(Executor& executor, Duration duration) { return {executor, duration}; }

}  // namespace pizarra
