#pragma once

// This machine's time. It begins at the wall clock, or where it is told to, and then goes on steadily, whatever is done
// to the wall clock: no timer, lease or deadline is early or late because somebody set it.
//
//   RealExecutor executor;
//   Job job = executor.spawn(agent.run());
//   executor.run_until([&] { return job.done(); });    // on the thread that made everything
//
// Destroying it cancels offloaded work and waits for it to notice.

#include <atomic>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <thread>

#include "blackboard/time/executor.hpp"
#include "blackboard/time/worker_pool.hpp"

namespace pizarra {

class RealExecutor : public Executor {
 public:
  explicit RealExecutor(Time begin = wall_clock());
  ~RealExecutor() override;
  RealExecutor(const RealExecutor&) = delete;
  RealExecutor& operator=(const RealExecutor&) = delete;

  static Time wall_clock();
  Time now() const override;
  void post(Callback callback) override;
  TimerId call_at(Time when, Callback callback) override;
  void cancel(TimerId timer) override;
  void watch_readable(int file, std::function<void()> callback) override;
  void unwatch_readable(int file) override;
  Task<void> offload(std::function<void(const std::function<bool()>&)> work, Duration virtual_cost) override;
  void run_until(std::function<bool()> finished) override;
  void stop() override;

 private:
  struct Offloaded;
  using Timers = std::map<std::pair<Time, TimerId>, Callback>;

  using Due = std::deque<std::pair<TimerId, Callback>>;

  bool run_posted(const std::function<bool()>& finished);
  bool run_timers(const std::function<bool()>& finished);
  bool run_due(const std::function<bool()>& finished);
  Due::iterator find_due(TimerId timer);
  bool has_work();
  void poll_files();
  void drain_wake_up();

  const std::chrono::steady_clock::time_point steady_start_;
  const Time start_;
  int wake_up_ = -1;
  std::atomic<bool> stopped_ = false;

  std::mutex mutex_;
  std::deque<Callback> posted_;

  std::atomic<std::thread::id> runner_;  // who runs, and needs no waking up

  TimerId next_timer_ = 1;
  Due due_;  // timers that were due when they were made, in order; one that was cancelled is empty
  Timers timers_;
  std::map<TimerId, Time> times_;
  std::map<int, std::shared_ptr<std::function<void()>>> files_;
  int rounds_without_files_ = 0;

  std::atomic<bool> ending_ = false;
  std::optional<WorkerPool> workers_{std::in_place};
};

}  // namespace pizarra
