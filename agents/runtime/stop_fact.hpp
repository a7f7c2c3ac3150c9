#pragma once

// Somebody's stop, the fact (stop WHO REASON): while one stands, no arm and no head begins to move.
//
//   const std::vector<Fact> stops = co_await facts_now(board, executor, any_stop());
//   fail("halted", stop_in_words(stops.front().datum), stops.front().datum);

#include <string>

#include "lisp/datum.hpp"

namespace pizarra::runtime {

// What all of them fit.
Datum any_stop();
// "anna says stop: changing the tray".
std::string stop_in_words(const Datum& stop);

}  // namespace pizarra::runtime
