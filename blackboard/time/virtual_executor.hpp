#pragma once

// Time that jumps: the next callback is always due, and it is exactly its time. The same callbacks give the same run.
//
//   VirtualExecutor executor;                         // it is 1970-01-01 00:00:00
//   Job job = executor.spawn(agent.run());
//   executor.run_for(10s);

#include <map>

#include "blackboard/time/executor.hpp"

namespace pizarra {

class VirtualExecutor : public Executor {
 public:
  Time now() const override { return now_; }
  void post(Callback callback) override;
  TimerId call_at(Time when, Callback callback) override;
  void cancel(TimerId timer) override;
  void watch_readable(int file, std::function<void()> callback) override;
  void unwatch_readable(int file) override;
  Task<void> offload(std::function<void(const std::function<bool()>&)> work, Duration virtual_cost) override;
  void run_until(std::function<bool()> finished) override;
  void stop() override { stopped_ = true; }

  // Runs what is due until `duration` has passed; time then stands exactly there, unless stopped.
  void run_for(Duration duration);
  // Whether nothing is left to do.
  bool idle() const { return due_.empty(); }

 private:
  void run_next();
  Time now_{};
  TimerId next_timer_ = 1;
  bool stopped_ = false;
  std::map<std::pair<Time, TimerId>, Callback> due_;
  std::map<TimerId, Time> times_;
};

}  // namespace pizarra
