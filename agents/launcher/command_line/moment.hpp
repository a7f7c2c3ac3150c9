#pragma once

// A moment of the past as people say it: `120` is a revision, `90s`, `5min`, `2h`, `1d` that long before the end,
// `2026-11-21T12:30:00` the local time, `@12.5` that many seconds after the journal's clock began, as a demo's begins
// at 0.

#include <string>

#include "blackboard/fact.hpp"
#include "lisp/result.hpp"

namespace pizarra {

// Failure bad-moment. `end`: what "before" counts from.
Result<Moment> moment_from_text(const std::string& text, Time end);

}  // namespace pizarra
