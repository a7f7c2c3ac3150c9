#pragma once

// Several tasks of one kind, some of them at a time.
//
//   std::vector<Task<void>> asking;
//   for (Board& board : boards) asking.push_back(ask(board));
//   co_await run_together(executor, std::move(asking), 64);     // until all are done

#include <vector>

#include "blackboard/time/executor.hpp"

namespace pizarra {

// Begins them in their order, and the next when one ends.
Task<void> run_together(Executor& executor, std::vector<Task<void>> tasks, std::size_t at_once);

}  // namespace pizarra
