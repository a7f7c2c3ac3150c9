#pragma once

// The context of every agent. An agent is a state machine over facts and timers. It is given all it may use in an
// AgentContext, and never reads a clock, sleeps, opens a socket or starts a thread by itself.
//
// Lifecycle: constructed (nothing happens), run() spawned on the executor (declares, announces its presence, serves),
// ended by destroying the Job that runs it; its lease then lapses and frees its name. A restarted agent reads its state
// from its facts.
//
//   VisionAgent vision(AgentContext{"vision", host, executor, *board, random}, camera, &streams);
//   const Job job = executor.spawn(keep(vision));     // awaits vision.run(); service.hpp shows what that does

#include <string>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"
#include "blackboard/time/random.hpp"

namespace pizarra::runtime {

struct AgentContext {
  std::string name;  // as in (agent NAME KIND HOST)
  std::string host;
  Executor& executor;
  Board& board;
  Random random;
};

class Agent {
 public:
  virtual ~Agent() = default;
  // Runs until destroyed, or until it meets something that it cannot mend.
  virtual Task<Result<void>> run() = 0;
};

}  // namespace pizarra::runtime
