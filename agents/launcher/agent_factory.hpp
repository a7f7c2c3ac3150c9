#pragma once

// How an agent of each kind is made from a cell's description: the one place that knows them all.
//
//   Result<std::unique_ptr<BuiltAgent>> vision = build_agent("vision", context, description, link, &streams);
//   Job job = executor.spawn((*vision)->run());

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/runtime/agent.hpp"
#include "blackboard/stream.hpp"
#include "drivers/simulation/link.hpp"
#include "drivers/simulation/world_config.hpp"
#include "lisp/forms/cell_file.hpp"
#include "lisp/parts.hpp"

namespace pizarra::launcher {

// The kind of the agent that a cell lists under this name: another of a kind is called KIND-NUMBER, as vision-2.
std::string kind_of_agent(const std::string& name);
// The fault in a typed kind of agent; empty where there is such a kind.
std::string kind_fault(const std::string& typed);
// Those that the cell has devices for, and the further ones that it names: who plays a story in the simulated world.
std::vector<std::string> agent_kinds(const forms::CellDescription& description);
// Those that the cell's hosts run.
std::vector<std::string> named_agents(const forms::CellDescription& description);

// Whether its cameras stand on one.
bool has_pan_tilt(const forms::CellDescription& description);

// Whether the agent has a device in the simulated world, which is reached over its socket, on this machine alone.
bool needs_world(const std::string& agent, const forms::CellDescription& description);

// The plug-in that drives the agent's device, whose process the agent reaches as it would the simulated world.
struct DevicePlugin {
  std::string device;   // arm or camera
  std::string library;  // its file's name; empty: there is none
};
DevicePlugin plugin_of(const std::string& agent, const forms::CellDescription& description);

// The simulated world of the cell, checked. Failures: bad-cell, and those of the arm file.
Result<simulation::WorldConfig> world_config(const forms::CellDescription& description, std::uint64_t seed);

// An agent with the devices it owns.
class BuiltAgent {
 public:
  BuiltAgent(Parts devices, std::unique_ptr<runtime::Agent> agent)
      : devices_(std::move(devices)), agent_(std::move(agent)) {}
  virtual ~BuiltAgent() = default;

  // Runs the agent until destroyed; when the agent ends by itself, the reason stays in ended().
  Task<void> run();
  const Result<void>* ended() const { return ended_ ? &*ended_ : nullptr; }
  // For a process that is to end: answers when nothing moves that this agent set in motion.
  virtual Task<void> stand_still() { co_return; }

 private:
  Parts devices_;
  std::unique_ptr<runtime::Agent> agent_;
  std::optional<Result<void>> ended_;
};

// Link and streams outlive the agent. Failures: unknown-agent, and those of the arm file.
Result<std::unique_ptr<BuiltAgent>> build_agent(const std::string& agent, runtime::AgentContext context,
                                                const forms::CellDescription& description, simulation::Link& link,
                                                Streams* streams);

}  // namespace pizarra::launcher
