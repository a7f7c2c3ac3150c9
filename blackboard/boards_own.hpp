#pragma once

// Relations of the board itself: those that it alone tells (`board-refusal`, `board-leads`), and the statistics that it
// makes up when it is asked (memory/statistics.hpp).

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra {

// The teller of the board's own changes; nobody else has this name.
inline constexpr std::string_view board_teller = "board";

inline bool is_statistics(std::string_view relation) {
  constexpr std::array<std::string_view, 5> names = {"relation-stats", "reader-stats", "journey-stats", "watcher-stats",
                                                     "client-stats"};
  return std::ranges::find(names, relation) != names.end();
}

inline bool is_told_by_the_board(std::string_view relation) {
  return relation == "board-refusal" || relation == "board-leads";
}

inline Failure left_to_the_board(std::string_view relation) {
  return {"not-permitted",
          std::string(relation) + " is the board's own: nobody else declares, tells or takes it",
          Datum::symbol(relation),
          {}};
}

}  // namespace pizarra
