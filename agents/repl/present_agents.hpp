#pragma once

// Who is on the board, and what they offer.
//
//   bool there = co_await is_present(prompt.board, "robot");
//   std::vector<Datum> offers = co_await offers_of(prompt.board, "robot"_sym);       // (monitor) ...

#include <set>

#include "agents/repl/prompt.hpp"

namespace pizarra::repl {

Task<bool> is_present(Board& board, std::string agent);
// `(OPERATION (PARAMETER KIND) ...)` of each; none where the board does not answer.
Task<std::vector<Datum>> offers_of(Board& board, Datum agent);
// The names that may be typed: agents and what they offer, relations, objects.
Task<std::set<std::string>> names_on(Board& board);

}  // namespace pizarra::repl
