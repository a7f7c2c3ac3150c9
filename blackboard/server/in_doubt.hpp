#pragma once

// A board that cannot confirm that it leads: another one may by now. It changes nothing and answers no question. A
// client that asks for it learns how things stood, and when that was last certain.
//
//   answer_in_doubt(permitted, keys, sender_key, frame, age);      // the frame to send back

#include <string>
#include <string_view>

#include "blackboard/server/key_folder.hpp"
#include "blackboard/server/permitted_board.hpp"

namespace pizarra::server {

// The answer of a board that last knew `age` ago that it leads; empty for clients that did not ask for it. Without keys
// null.
std::string answer_in_doubt(PermittedBoard& board, const KeyFolder* keys, const std::string& sender_key,
                            std::string_view frame, Duration age);

}  // namespace pizarra::server
