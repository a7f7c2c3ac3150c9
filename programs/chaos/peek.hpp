#pragma once

// Reads the facts on the board of a running cell from outside: no agent and no session takes part in it.
//
//   std::vector<Datum> facts = facts_of(cell.board(), "(goal-state 1 ? ?)");   // none where the board does not live

#include <optional>
#include <string_view>
#include <vector>

#include "blackboard/memory/memory_board.hpp"

namespace pizarra::chaos {

std::vector<Datum> facts_of(const memory::MemoryBoard* board, const Datum& pattern);
std::vector<Datum> facts_of(const memory::MemoryBoard* board, std::string_view pattern);
// Of the first that matches.
std::optional<FactId> fact_id_of(const memory::MemoryBoard* board, const Datum& pattern);

// What is in hand: the operator's name, empty where none is, and the servo's state.
struct InHand {
  std::string operation;
  int servo_state = 0;
};
InHand in_hand(const memory::MemoryBoard* board);

}  // namespace pizarra::chaos
