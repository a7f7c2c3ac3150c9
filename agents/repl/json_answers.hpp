#pragma once

// Answers as JSON, for programs: facts and values as their text. Failures: lisp/json.hpp.
//
//   json_answer(answer)     {"bindings":{"?x":"circle"},"facts":["(clear circle)"]}

#include <span>
#include <string>

#include "blackboard/query.hpp"
#include "lisp/json.hpp"

namespace pizarra::repl {

std::string json_answer(const Answer& answer);
std::string json_answers(std::span<const Answer> answers);
// Strings as they are, everything else as its text.
std::string json_values(std::span<const Datum> values);

}  // namespace pizarra::repl
