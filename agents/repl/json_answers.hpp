#pragma once

// Answers and failures as JSON, for programs: facts and values as their text.
//
//   json_error(failure)     {"error":{"symbol":"unknown-agent","sentence":"...","subject":"robot"}}
//   json_answer(answer)     {"bindings":{"?x":"circle"},"facts":["(clear circle)"]}

#include <span>
#include <string>

#include "blackboard/query.hpp"

namespace pizarra {

// The inside alone, and the whole object. There is a "place" where text was read.
std::string json_failure(const Failure& failure);
std::string json_error(const Failure& failure);

std::string json_answer(const Answer& answer);
std::string json_answers(std::span<const Answer> answers);
// Strings as they are, everything else as its text.
std::string json_values(std::span<const Datum> values);

}  // namespace pizarra
