#pragma once

// The coordinator: takes goals, sees to it that they are planned, and drives the arm by what the eyes see until they
// hold (the thesis' steps a to h). It tells its actions and their reasons as facts (docs/facts/coordinator.md).
//
// Lifecycle: constructed, run() spawned. Its state is durable facts: killed and made anew it goes on with the goal it
// had. A domain file that cannot be read ends run() with the failure.
//
//   CoordinatorAgent coordinator(context, {.domain_file = "domains/blocks.scm"});
//   Job job = executor.spawn(...coordinator.run()...);

#include <memory>

#include "agents/coordinator/options.hpp"
#include "agents/runtime/agent.hpp"

namespace pizarra::coordinator {

class CoordinatorAgent : public runtime::Agent {
 public:
  CoordinatorAgent(runtime::AgentContext context, CoordinatorOptions options);
  ~CoordinatorAgent() override;
  Task<Result<void>> run() override;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace pizarra::coordinator
