#pragma once

// Telling facts so that they arrive: a board that is away for a while is tried again.
//
//   const Result<Revision> told = co_await commit(board, executor, std::move(transaction));
//   const std::vector<Fact> grippers = co_await facts_now(board, executor, pattern);

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra::coordinator {

// Commits the transaction, however long the board is away, whether it can be made to last or not. Any other failure is
// ours and is answered.
Task<Result<Revision>> commit(Board& board, Executor& executor, Transaction transaction);

// Every fact that fits, however long the board is away; none where the question itself is wrong.
Task<std::vector<Fact>> facts_now(Board& board, Executor& executor, Datum pattern);

}  // namespace pizarra::coordinator
