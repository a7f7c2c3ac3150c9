#pragma once

// Who serves whom: the coordinator of the prompt, and the command that lists and changes roles.
//
//   Result<std::string> coordinator = co_await present_coordinator(prompt.context, "would pursue a goal");
//   Evaluation outcome = co_await wire(prompt, typed);       // (wire coordinator eyes vision-2)

#include "agents/repl/prompt.hpp"
#include "agents/runtime/roles.hpp"

namespace pizarra::repl {

// The agent that is the coordinator for prompts.
Task<std::string> coordinator_of_prompts(Board& board);
// The same where it must be present: failure absent, which says what it is needed for.
Task<Result<std::string>> present_coordinator(runtime::AgentContext& context, std::string needed_for);
Task<Evaluation> wire(Prompt& prompt, Typed typed);

}  // namespace pizarra::repl
