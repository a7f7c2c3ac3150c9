#pragma once

// Answers as people read them.
//
//   bindings_text(answer)     ?x = circle  ?y = triangle

#include <string>

#include "blackboard/query.hpp"

namespace pizarra::repl {

// `yes` where nothing is bound.
std::string bindings_text(const Answer& answer);

}  // namespace pizarra::repl
