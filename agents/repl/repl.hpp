#pragma once

// The prompt and its interpreter together.
//
//   Interpreter interpreter(context, service, [&](const std::string& line) { terminal.print(line); }, patience);
//   co_await run_prompt(context, interpreter, terminal);     // until (quit) or the end of the input

#include "agents/repl/interpreter.hpp"
#include "agents/repl/terminal.hpp"

namespace pizarra::repl {

// Reads and evaluates until the end; meanwhile what is taught and the coordinator's story are shown as they happen.
// What fails is shown and the prompt goes on; answers the first form's outcome that was not done, else `done`.
Task<Evaluation> run_prompt(runtime::AgentContext& context, Interpreter& interpreter, Terminal& terminal);

// Evaluates the forms in order, for scripts. Stops at the first that does not succeed and answers what became of it.
Task<Evaluation> run_forms(Interpreter& interpreter, std::vector<std::string> forms);

}  // namespace pizarra::repl
