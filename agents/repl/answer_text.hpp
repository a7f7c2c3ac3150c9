#pragma once

// Answers as people read them, and as JSON for programs: there facts and values are their text (failures:
// lisp/json.hpp).
//
//   bindings_text(answer)   ?x = circle  ?y = triangle
//   json_answer(answer)     {"bindings":{"?x":"circle"},"facts":["(clear circle)"]}

#include <span>
#include <string>

#include "blackboard/query.hpp"
#include "lisp/json.hpp"

namespace pizarra::repl {

// `yes` where nothing is bound.
std::string bindings_text(const Answer& answer);

std::string json_answer(const Answer& answer);
std::string json_answers(std::span<const Answer> answers);
// Strings as they are, everything else as its text.
std::string json_values(std::span<const Datum> values);

}  // namespace pizarra::repl
