#pragma once

// What the prompt says of the eyes: where they see the objects, and what their answers have no room for.
//
//   Evaluation outcome = co_await list_objects(prompt, typed);                                   // (objects)
//   std::optional<Datum> reason = why_failed(answer);
//   std::vector<Datum> remarks = co_await remarks_on(prompt.context, "vision", operation, answer);

#include <optional>

#include "agents/repl/prompt.hpp"

namespace pizarra::repl {

Task<Evaluation> list_objects(Prompt& prompt, Typed typed);
// The sentence of an answer whose text says FAIL.
std::optional<Datum> why_failed(const Datum& answer);
// Sentences: what the learned object looks like, how long a mode lasts, and why there are no images.
// None of agents that are no eyes.
Task<std::vector<Datum>> remarks_on(runtime::AgentContext& context, std::string agent, Datum operation, Datum answer);

}  // namespace pizarra::repl
