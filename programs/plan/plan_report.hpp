#pragma once

// A plan as `pizarra plan` prints it: for people, for programs, or as PDDL's own tools read it.
//
//   print_plan(report, PlanFormat::pddl);      // (pick-up b1)
//                                              // (stack b1 b2)

#include <cstdint>
#include <string>

#include "agents/planner/task/planning_task.hpp"

namespace pizarra::programs {

enum class PlanFormat : std::uint8_t { readable, pddl, json };

struct PlanReport {
  planner::PlanSteps steps;
  std::string engine;
  bool fewest_steps = false;   // proved
  bool out_of_memory = false;  // it might have become shorter
  std::int64_t cost = 0;
  bool counts_cost = false;
  double seconds = 0;
};

std::string plan_text(const PlanReport& report, PlanFormat format);

}  // namespace pizarra::programs
