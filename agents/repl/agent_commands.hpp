#pragma once

// The command that lists the agents, and asking one of them, which needs no command.
//
//   Evaluation outcome = co_await ask_agent(prompt, "robot", operation);      // (robot (monitor))

#include "agents/repl/prompt.hpp"

namespace pizarra::repl {

Task<Evaluation> list_agents(Prompt& prompt, Typed typed);
// Shows what it answers, and what is to be remarked on that.
Task<Evaluation> ask_agent(Prompt& prompt, std::string agent, Datum operation);

}  // namespace pizarra::repl
