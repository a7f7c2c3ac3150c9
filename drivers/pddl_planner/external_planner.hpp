#pragma once

// Any PDDL planner on this host, behind a command: {domain} and {problem} stand for files that are made for it, {plan}
// for the one it may write. Where it writes none, its plan is looked for in what it prints.
//
//   ExternalPlanner planner("fast-downward --plan-file {plan} {domain} {problem} --search 'astar(lmcut())'");
//   const Result<PlanClaim> claim = planner.plan(domain_text, problem_text, operators, [] { return false; });
//   if (!valid(claim->actions) && claim->ended) return fail(*claim->ended);
//
// Its files live in a folder of their own that is gone afterwards, as is every process it started. Its time and memory
// are bounded (planner_process.hpp). The plan is what the planner claims, and is to be validated.

#include <optional>

#include "drivers/pddl_planner/plan_output.hpp"
#include "drivers/pddl_planner/planner_process.hpp"

namespace pizarra::pddl_planner {

struct PlanClaim {
  PlanActions actions;
  // How the planner ended where it did not end well; that is what went wrong, where the plan does not work.
  std::optional<Failure> ended;
};

class ExternalPlanner {
 public:
  explicit ExternalPlanner(std::string command, ProcessLimits limits = {})
      : command_(std::move(command)), limits_(limits) {}

  // Failures: bad-command ({domain} or {problem} is missing); planner-missing (no such program); planner-crashed (a
  // signal, also one that a shell tells as a status of 128 and more); planner-failed (an exit status, and no plan);
  // garbage (no plan in its output, or no plain file in its plan's place); time-out, cancelled, too-much-output;
  // no-folder (nowhere to write).
  Result<PlanClaim> plan(const std::string& domain, const std::string& problem, const PlanOperators& operators,
                         const std::function<bool()>& cancelled) const;

 private:
  std::string command_;
  ProcessLimits limits_;
};

}  // namespace pizarra::pddl_planner
