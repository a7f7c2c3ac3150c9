#pragma once

// Why facts stand: who told them, because of what, and why that stands.
//
//   std::vector<std::string> lines = co_await why_facts(board, pattern);
//   // (belt stopped)  by conveyor
//   //   because (rule conveyor stop "(barrier exit blocked)")  by conveyor
//   //   because (barrier exit blocked)  by prompt-17

#include "blackboard/board.hpp"

namespace pizarra::repl {

// None where no fact fits. A reason that has gone meanwhile is said to have. Failures: those of the board.
Task<Result<std::vector<std::string>>> why_facts(Board& board, Datum pattern);

}  // namespace pizarra::repl
