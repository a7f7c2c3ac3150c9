#pragma once

// Questions about facts of agents that may not be there yet. The board refuses a question about a relation that nobody
// has declared, and counts the refusal. These functions look first whether the relation is declared.
//
//   Result<std::vector<Fact>> learned = co_await facts_if_declared(board, pattern);       // none before eyes have come
//   Result<std::unique_ptr<Watch>> watch = co_await watch_when_declared(board, query);    // waits for them

#include "blackboard/board.hpp"

namespace pizarra::runtime {

// A client that may not ask about relations takes them for declared.
Task<Result<bool>> is_declared(Board& board, std::string relation);
// Every fact that fits, and none where its relation is not declared.
Task<Result<std::vector<Fact>>> facts_if_declared(Board& board, Datum pattern);
// The answers that hold, and none where a relation of the query is not declared.
Task<Result<Answers>> answers_if_declared(Board& board, Query query);
// Waits until all its relations are declared, however long that takes. It looks again whenever an agent comes: by then
// that agent has declared what it posts.
Task<Result<std::unique_ptr<Watch>>> watch_when_declared(Board& board, Query query);

}  // namespace pizarra::runtime
