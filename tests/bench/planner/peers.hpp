#pragma once

// Foreign planners that the bench runs in turns with ours, where they are installed: on PATH under their usual names,
// or given as NAME=COMMAND.
//
//   const Peers peers = installed_peers({"M=/opt/M -Q -o {plan} {domain} {problem}"});
//   figures.say({..., .peers = seconds_of(peers, task, 60)});

#include <optional>
#include <string>
#include <vector>

#include "agents/planner/task/planning_task.hpp"
#include "tests/bench/figures.hpp"

namespace pizarra::bench {

struct PeerPlanner {
  std::string name;
  std::optional<std::string> command;  // none: not installed
};

// Madagascar M and FD with lmcut are optimal, FF is not.
std::vector<PeerPlanner> installed_peers(const std::vector<std::string>& given);
// From start to end of its process, with a plan that our validator accepts; none otherwise.
std::vector<Peer> seconds_of(const std::vector<PeerPlanner>& peers, const planner::PlanningTask& task, double limit_s);
std::optional<double> fastest(const std::vector<Peer>& peers);

}  // namespace pizarra::bench
