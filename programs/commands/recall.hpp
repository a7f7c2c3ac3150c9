#pragma once

// A question to a board that may have been replaced, as `ask --old` puts it: what it answers, and how old that may be.

#include "blackboard/query.hpp"
#include "programs/commands/board_session.hpp"

namespace pizarra::programs {

// The exit status.
int print_recalled(const Destination& to, const Query& query, repl::Style style);

}  // namespace pizarra::programs
