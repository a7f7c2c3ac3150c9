#pragma once

// A process of a simulated run: an executor of its own on the virtual time that all share. Its clock may differ from
// others', go faster or slower, and jump ahead. It may be held up as by SIGSTOP, or with its host, whose clock stands
// meanwhile. And it may end at any suspension point, as by SIGKILL: from then on nothing of it runs, and whoever has it
// can take down what it was made of.
//
//   VirtualExecutor time;
//   Process vision(time, {.clock_ahead = 3s, .drift = 100e-6});
//   Job job = vision.spawn(agent.run());
//   vision.pause();                       // what becomes due waits for resume()
//   vision.suspend();                     // the same, and its clock stands: it is behind others' from then on
//   vision.jump(2s);                      // what waits is due 2 s earlier
//   vision.hold_at(vision.steps() + 7, [&] { vision.pause(); });
//   vision.kill_at(vision.steps() + 7, [&] { job = Job(); });
//
// It outlives what runs on it.

#include <deque>
#include <functional>
#include <map>
#include <optional>

#include "blackboard/time/executor.hpp"

namespace pizarra::simulated {

class Process : public Executor {
 public:
  struct Clock {
    Duration ahead{};  // of the shared time, when it begins
    double drift = 0;  // it goes this part faster
  };

  Process(Executor& time, Clock clock);
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() override;

  Time now() const override;
  void post(Callback callback) override { call_at(now(), std::move(callback)); }
  TimerId call_at(Time when, Callback callback) override;
  void cancel(TimerId timer) override;
  // Virtual time refuses both by assertion.
  void watch_readable(int file, std::function<void()> callback) override;
  void unwatch_readable(int file) override;
  // Takes as long as `virtual_cost` and what the work says that it spent (spend()).
  Task<void> offload(std::function<void(const std::function<bool()>&)> work, Duration virtual_cost) override;
  // Only who has the shared time runs it.
  void run_until(std::function<bool()> finished) override;
  void stop() override {}

  // That a device took so long, which the work in hand has waited for.
  void spend(Duration time) { spent_ += time; }

  void pause() { paused_ = true; }
  void suspend();
  void resume();
  bool paused() const { return paused_; }
  // Its clock goes ahead by so much at once. A clock that programs read goes never back (real_executor.hpp).
  void jump(Duration ahead);
  // Callbacks that have run.
  std::uint64_t steps() const { return steps_; }
  // After that many in all, nothing runs any more, and `then` is called, from outside of it.
  void kill_at(std::uint64_t steps, Callback then);
  // After that many in all, `then` is called, before anything else of it runs.
  void hold_at(std::uint64_t steps, Callback then);
  void kill();
  bool alive() const { return alive_; }

 private:
  struct Waiting {
    Time when{};     // by its own clock
    TimerId at = 0;  // of the shared time; 0: it was due while it was paused
    Callback callback;
  };
  Time shared_now() const { return suspended_since_.value_or(time_.now()); }
  void wait_for(TimerId timer, Waiting& waiting);
  void wait_anew();
  void become_due(TimerId timer);
  void run(TimerId timer);

  Executor& time_;
  Clock clock_;
  const Time begun_;
  std::optional<Time> suspended_since_;
  TimerId next_ = 1;
  std::map<TimerId, Waiting> waiting_;
  std::deque<TimerId> held_up_;
  bool paused_ = false;
  bool alive_ = true;
  Duration spent_{};
  std::uint64_t steps_ = 0;
  std::uint64_t last_step_ = ~std::uint64_t{0};
  Callback then_;
  std::uint64_t held_step_ = ~std::uint64_t{0};
  Callback when_held_;
};

}  // namespace pizarra::simulated
