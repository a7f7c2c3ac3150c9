#pragma once

// A whole cell in one process: the board, the simulated world with its devices, and the agents, on one executor. An
// agent can be killed, as if its process had died, and started anew.
//
//   VirtualExecutor executor;
//   LocalCell cell(executor, description, seed);
//   for (const auto& kind : agent_kinds(description)) cell.start(kind);
//   cell.kill("vision");                       // its presence lapses within its lease
//   cell.start("vision");

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "agents/launcher/agent_factory.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/stream.hpp"
#include "drivers/simulation/world.hpp"

namespace pizarra::launcher {

class LocalCell {
 public:
  // world_config(description, seed) has succeeded.
  LocalCell(Executor& executor, forms::CellDescription description, std::uint64_t seed);
  ~LocalCell();
  LocalCell(const LocalCell&) = delete;
  LocalCell& operator=(const LocalCell&) = delete;

  Executor& executor() { return executor_; }
  memory::MemoryBoard& board() { return board_; }
  simulation::Link& link() { return link_; }
  Streams& streams() { return streams_; }
  const forms::CellDescription& description() const { return description_; }
  Random random(std::string_view purpose) const { return random_.split(purpose); }

  // By its kind, or as another of it (kind_of_agent). Failures: unknown-agent, already-running, and what keeps the
  // agent from being made.
  Result<void> start(const std::string& kind, const std::string& host = "localhost");
  // Not from inside the agent's own task. Failure: not-running.
  Result<void> kill(const std::string& kind);
  // Why an agent that was started has ended by itself; nothing while it runs.
  std::optional<Failure> ended(const std::string& kind) const;

 private:
  struct Running;

  Executor& executor_;
  forms::CellDescription description_;
  Random random_;
  memory::MemoryBoard board_;
  LocalStreams streams_;
  simulation::World world_;
  simulation::LocalLink link_;
  std::map<std::string, std::unique_ptr<Running>> agents_;
};

}  // namespace pizarra::launcher
