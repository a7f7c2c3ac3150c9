#pragma once

// Ends planning from outside: Ctrl-C, SIGTERM, or the time that was given. On a terminal it shows that time passes.
//
//   PlanClock clock(10.0);
//   engine.solve(problem, budget, [&] { return clock.over(); });
//   if (clock.interrupted()) return exit_interrupted;

#include <chrono>
#include <limits>

#include "blackboard/time/stop_signals.hpp"

namespace pizarra::programs {

class PlanClock {
 public:
  static constexpr double for_ever = std::numeric_limits<double>::infinity();

  // Counts from now on.
  explicit PlanClock(double limit_s);
  ~PlanClock();
  PlanClock(const PlanClock&) = delete;
  PlanClock& operator=(const PlanClock&) = delete;

  // A limit where none was given.
  void shorten(double limit_s) { limit_s_ = limit_s_ == for_ever ? limit_s : limit_s_; }

  // Cheap enough to be asked at every node of a search.
  bool over();
  bool interrupted() const { return interrupted_; }
  double seconds() const;
  // Takes what it shows off the terminal.
  void hide();

 private:
  void show(double now_s);

  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  double limit_s_;
  double next_look_s_ = 0;
  double next_show_s_ = 2;
  StopSignals signals_;
  bool on_terminal_;
  bool shown_ = false;
  bool interrupted_ = false;
  bool time_up_ = false;
};

}  // namespace pizarra::programs
