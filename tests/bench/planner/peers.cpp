#include "tests/bench/planner/peers.hpp"

#include <algorithm>

#include "agents/planner/external/external_plan.hpp"
#include "lisp/installed_program.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

std::vector<PeerPlanner> installed_peers(const std::vector<std::string>& given) {
  struct Usual {
    const char* name;
    const char* arguments;
  };
  constexpr Usual usual[] = {{"M", " -Q -o {plan} {domain} {problem}"},
                             {"fast-downward", " --plan-file {plan} {domain} {problem} --search 'astar(lmcut())'"},
                             {"ff", " -o {domain} -f {problem}"}};
  std::vector<PeerPlanner> peers;
  for (const Usual& planner : usual) {
    PeerPlanner peer{planner.name, {}};
    if (const std::optional<std::string> program = installed_program(planner.name))
      peer.command = *program + planner.arguments;
    peers.push_back(std::move(peer));
  }
  for (const std::string& text : given) {
    const std::size_t equals = text.find('=');
    PeerPlanner peer{text.substr(0, equals), text.substr(equals + 1)};
    const auto known = std::ranges::find(peers, peer.name, &PeerPlanner::name);
    if (known != peers.end()) {
      *known = std::move(peer);
    } else {
      peers.push_back(std::move(peer));
    }
  }
  return peers;
}

std::vector<Peer> seconds_of(const std::vector<PeerPlanner>& peers, const planner::PlanningTask& task, double limit_s) {
  std::vector<Peer> measured;
  for (const PeerPlanner& peer : peers) {
    measured.push_back({peer.name, {}});
    if (!peer.command) continue;
    const pddl_planner::ExternalPlanner planner(*peer.command, {.seconds = limit_s});
    Result<planner::PlanSteps> plan = planner::PlanSteps{};
    const double seconds = seconds_of([&] { plan = planner::plan_externally(planner, task, [] { return false; }); });
    if (plan) measured.back().value = seconds;
  }
  return measured;
}

std::optional<double> fastest(const std::vector<Peer>& peers) {
  std::optional<double> least;
  for (const Peer& peer : peers) {
    if (peer.name != "ff" && peer.value && (!least || *peer.value < *least)) least = peer.value;
  }
  return least;
}

}  // namespace pizarra::bench
