#pragma once

// Watches a story for how the coordinator takes its disturbances: how long after a difference it has decided, and how
// much of its plan it keeps. It also asks the world how fast a cube moves as the fingers begin to close.
//
//   LoopWatch watch;
//   options.beside = [&](launcher::LocalCell& cell) { return watch.follow(cell); };

#include <optional>
#include <vector>

#include "agents/launcher/local_cell.hpp"
#include "tests/bench/loop/retry_watch.hpp"

namespace pizarra::bench {

class LoopWatch {
 public:
  Task<void> follow(launcher::LocalCell& cell);

  // Of each disturbance that was noticed: from its telling to the plan that is gone on with, in the cell's time.
  const std::vector<double>& decisions_s() const { return decisions_s_; }
  // The same: which part, 0..1, of what was left of the old plan is in the new one.
  const std::vector<double>& kept() const { return kept_; }
  // From a grasp to the release.
  const std::vector<double>& carries_s() const { return carries_s_; }
  // Each time the fingers began to close, the speed of the cube that moved fastest.
  const std::vector<double>& grips_mm_s() const { return grips_mm_s_; }
  // Of each slip that was made good.
  const std::vector<Retry>& retries() const { return retry_watch_.retries(); }

 private:
  Task<void> follow_pattern(Board& board, Executor& executor, Datum pattern);
  void take(const Datum& fact, double now_s);
  void take_event(const Datum& event, double now_s);
  void take_plan(const Datum& plan, double now_s);
  void take_micro_task(const Datum& task, double now_s);
  Task<void> measure_grip();

  launcher::LocalCell* cell_ = nullptr;
  std::int64_t last_event_ = 0;
  std::vector<Datum> left_;  // of the plan, the operation in hand first
  std::optional<double> differed_s_;
  std::optional<double> grasped_s_;
  std::vector<double> decisions_s_;
  std::vector<double> kept_;
  std::vector<double> carries_s_;
  std::vector<double> grips_mm_s_;
  RetryWatch retry_watch_;
  Job grip_;
};

}  // namespace pizarra::bench
