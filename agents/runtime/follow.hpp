#pragma once

// A watch that outlives the board's absence and may begin before its relation is declared.
//
//   jobs.push_back(executor.spawn(follow(context, pattern, [this](Change change) { return take(std::move(change));
//   })));

#include <functional>

#include "agents/runtime/agent.hpp"

namespace pizarra::runtime {

// Calls `take` with each change of the facts that fit the pattern, one after another, for ever. The context outlives
// it.
Task<void> follow(AgentContext& context, Datum pattern, std::function<Task<void>(Change)> take);

}  // namespace pizarra::runtime
