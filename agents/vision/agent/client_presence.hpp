#pragma once

// Which clients are there, so that whoever dies lets go of the modes that it held.
//
//   ClientPresence presence(context);
//   std::string holder = co_await presence.holder_for("coordinator");
//   if (co_await presence.let_dead_go(holders)) ...               // once a second

#include <set>

#include "agents/runtime/agent.hpp"
#include "agents/vision/agent/mode_holders.hpp"

namespace pizarra::vision {

class ClientPresence {
 public:
  // It outlives this.
  explicit ClientPresence(runtime::AgentContext& context) : context_(context) {}

  Task<Result<bool>> is_present(std::string client);
  // The client as one who can hold a mode: itself while it is present, ModeHolders::absent otherwise, from now on for
  // as long as these hold what they began.
  Task<std::string> holder_for(std::string client);
  // Takes all modes from those who were present neither now nor the last time, and from those who never were a while
  // after they asked for one last. Whether anything was taken.
  Task<bool> let_dead_go(ModeHolders& holders);

 private:
  runtime::AgentContext& context_;
  std::set<std::string> missing_;  // holders who were not present at the last look
  Time absent_until_ = {};         // how long ModeHolders::absent holds what it does
};

}  // namespace pizarra::vision
