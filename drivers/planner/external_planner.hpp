#pragma once

// Any PDDL planner on this host, behind a command: {domain} and {problem} stand for files that are made for it, {plan}
// for the one it may write. Where it writes none, its plan is looked for in what it prints.
//
//   ExternalPlanner planner("fast-downward --plan-file {plan} {domain} {problem} --search 'astar(lmcut())'");
//   const Result<PlanActions> actions = planner.plan(domain_text, problem_text, operators, [] { return false; });
//
// Its files live in a folder of their own that is gone afterwards, as is every process it started. The plan is what the
// planner claims, and is to be validated.

#include "drivers/planner/plan_output.hpp"
#include "drivers/planner/planner_process.hpp"

namespace pizarra {

class ExternalPlanner {
 public:
  explicit ExternalPlanner(std::string command, ProcessLimits limits = {})
      : command_(std::move(command)), limits_(limits) {}

  // Failures: bad-command ({domain} or {problem} is missing), planner-missing (no such program), planner-crashed (a
  // signal, also one that a shell tells as a status of 128 and more), planner-failed (an exit status, and no plan),
  // garbage (no plan in what it wrote, or no plain file in its plan's place), time-out, cancelled, too-much-output,
  // no-folder (nowhere to write).
  Result<PlanActions> plan(const std::string& domain, const std::string& problem, const PlanOperators& operators,
                           const std::function<bool()>& cancelled) const;

 private:
  std::string command_;
  ProcessLimits limits_;
};

}  // namespace pizarra
