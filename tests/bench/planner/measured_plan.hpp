#pragma once

// One plan, made in a process of its own, so that its memory is its own.
//
//   const std::optional<MeasuredPlan> plan = measured(task, Mode::fast, 1.0);
//   note_of(plan);        // "46 actions in 46 steps, fast, CPU 12.3 ms, 5 MB"

#include <optional>
#include <string>

#include "agents/planner/task/planning_task.hpp"

namespace pizarra::bench {

enum class Mode { optimal, fast_first, fast };

struct MeasuredPlan {
  double seconds = 0;  // with grounding; of the first plan in fast mode
  double cpu_s = 0;    // of processor time, until this plan was found, the last one in fast mode
  double memory_mb = 0;
  std::size_t actions = 0;
  std::size_t steps = 0;
  std::string engine;
};

// None: no valid plan in the time given. In fast mode the plan is the best when the time is over.
std::optional<MeasuredPlan> measured(const planner::PlanningTask& task, Mode mode, double limit_s);
std::string note_of(const MeasuredPlan& plan);

}  // namespace pizarra::bench
