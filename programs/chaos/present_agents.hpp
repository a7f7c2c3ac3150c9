#pragma once

// Which agents are present, and in which of their lives. An agent's presence outlives it until its lease lapses: one
// that was started again is present only once it stands there by a fact of its own.
//
//   PresentAgents agents;
//   const PresentAgents::Change change = agents.look("planner", life, fact);   // none where no presence is told
//   agents.is_present("planner", life);

#include <map>
#include <optional>
#include <string>

#include "blackboard/fact.hpp"

namespace pizarra::chaos {

class PresentAgents {
 public:
  enum class Change { none, came, went };

  // `presence`: the fact on the board that says so. `life`: in which the agent is now.
  Change look(const std::string& kind, int life, std::optional<FactId> presence);
  // Whether that life is.
  bool is_present(const std::string& kind, int life) const;

 private:
  struct Presence {
    FactId fact;
    int life;
  };
  std::map<std::string, Presence> present_;
};

}  // namespace pizarra::chaos
