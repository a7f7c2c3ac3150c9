#pragma once

// Does what a person says in plain English, by the robot's operations and the coordinator's goals alone: it knows
// neither arm nor domain.
//
//   (request r1 speech (say "move left 5 centimetres"))    -> (reply r1 (ok "(move-h left 50)" true))
//   (request r2 speech (say "pick up the circle"))         -> (reply r2 (ok "(goal (holding circle))" 1))
//
// It asks the robot and the coordinator that play its roles `robot` and `coordinator`.
// The answer is what was understood, and what the agent asked answered. Failures: not-understood, and the agent's own.

#include "agents/runtime/roles.hpp"

namespace pizarra::speech {

class SpeechAgent : public runtime::Agent {
 public:
  explicit SpeechAgent(runtime::AgentContext context);
  Task<Result<void>> run() override;

 private:
  Task<Result<Datum>> say(Datum operation);

  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
  runtime::Roles roles_;
};

}  // namespace pizarra::speech
