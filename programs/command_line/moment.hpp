#pragma once

// A moment of the past as people say it: `120` is a revision, `90s`, `5min`, `2h`, `1d` that long before the end,
// `2026-11-21T12:30:00` the local time, `@12.5` that many seconds after the journal's clock began, as a demo's begins
// at 0.

#include <CLI/CLI.hpp>
#include <string>

#include "blackboard/fact.hpp"
#include "lisp/result.hpp"

namespace pizarra::programs {

// `end`: what "before" counts from, and nothing is later than. Failures bad-moment and not-yet.
Result<Moment> moment_from_text(const std::string& text, Time end);

// `2026-11-21T12:30:00`, or `@12.500000` of a clock that begins at 0.
std::string time_text(Time when);

// The argument of an option `--at`; an empty one names no moment.
CLI::Validator moment_check();

}  // namespace pizarra::programs
