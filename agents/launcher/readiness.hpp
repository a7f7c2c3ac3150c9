#pragma once

// Waiting for a cell that is coming up, whose agents declare their relations one after another.
//
//   const Result<void> there = co_await await_agents(cell, board, {"robot", "vision"});
//   const Result<void> taught = co_await await_teaching(board, cell.executor());

#include "agents/launcher/local_cell.hpp"

namespace pizarra::launcher {

// To wait until the program ends.
inline constexpr Duration for_ever = 86400s;

// As await_answer(), also when the relations are yet to be declared.
Task<Result<Answer>> await_when_declared(Board& board, Executor& executor, Query query, Time deadline);

// The agents are present, each under its own name: two may be of one kind. Failure: no-agents.
Task<Result<void>> await_agents(LocalCell& cell, Board& board, std::vector<std::string> kinds);
// Those of them that have an arm or a pan-tilt unit know where it stands. Failure: no-device.
Task<Result<void>> await_devices(LocalCell& cell, Board& board, std::vector<std::string> kinds);
// The person has shown every object to the eyes. Failure: not-taught.
Task<Result<void>> await_teaching(Board& board, Executor& executor);

}  // namespace pizarra::launcher
