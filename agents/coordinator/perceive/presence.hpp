#pragma once

// Which agents are present, by their (agent NAME KIND HOST) facts.
//
//   presence.start();
//   bool there = co_await presence.wait_for("robot", deadline);

#include <set>
#include <string>

#include "agents/runtime/agent.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::coordinator {

class Presence {
 public:
  // The context outlives it.
  explicit Presence(runtime::AgentContext& context) : context_(context), changed_(context.executor) {}

  void start();
  bool has(const std::string& agent) const { return present_.contains(agent); }
  // True once the agent is present, false at the deadline.
  Task<bool> wait_for(std::string agent, Time deadline);

 private:
  Task<void> take(Change change);

  runtime::AgentContext& context_;
  std::set<std::string, std::less<>> present_;
  WaitList changed_;
  Job following_;
};

}  // namespace pizarra::coordinator
