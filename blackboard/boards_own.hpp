#pragma once

// Relations of the board itself: those that it alone tells (`board-refusal`, `board-leads`), and those that it makes up
// when it is asked: the statistics (memory/statistics.hpp), what a client may do (memory/own_permissions.hpp), and why
// a fact stands (store/provenance.hpp).
//
//   if (is_made_up(relation.name)) return fail(left_to_the_board(relation.name));

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra {

// The teller of the board's own changes; nobody else has this name.
inline constexpr std::string_view board_teller = "board";

inline constexpr std::string_view own_permission = "own-permission";
inline constexpr std::string_view provenance = "provenance";

inline bool is_made_up(std::string_view relation) {
  constexpr std::array<std::string_view, 7> names = {"relation-stats", "reader-stats", "journey-stats", "watcher-stats",
                                                     "client-stats",   own_permission, provenance};
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
