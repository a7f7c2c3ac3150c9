#pragma once

// Why a fact can never hold although each thing that it needs may: an action needs at once what never holds together.
//
//   const std::vector<BlockedWay> ways = why_never_together(problem, goal, cancelled);
//   write(problem.actions[ways.back().action].name);      // (stack a a)
//   ways.back().conflict;                                 // (clear a) and (holding a)

#include "agents/planner/task/planning_task.hpp"
#include "agents/planner/task/problem.hpp"

namespace pizarra::planner {

// The first way to a fact, were nothing ever deleted, and what stands in it.
struct BlockedWay {
  std::size_t fact = 0;
  std::size_t action = 0;
  std::vector<std::size_t> conflict;  // of what the action needs: never together, and as few as were found
  bool only_way = true;
};

// Of a fact that was proved never to hold. While a way needs one fact that never holds by itself, the next is the way
// to that; the last one's conflict is of several. Empty where the fact could not even be reached if nothing were
// deleted.
std::vector<BlockedWay> why_never_together(const Problem& problem, std::size_t fact,
                                           const std::function<bool()>& cancelled);
// The same in a sentence, with the names of the task.
std::string never_together_in_words(const PlanningTask& task, const Problem& problem, const Datum& fact,
                                    const std::function<bool()>& cancelled);

}  // namespace pizarra::planner
