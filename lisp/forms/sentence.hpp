#pragma once

// Plain English for an arm and its cell, as one request of another agent. (pizarra sentences) lists what is understood.
//
//   read_sentence("Move left 5 centimetres.")     // robot, (move-h left 50)
//   read_sentence("pick up the circle")           // coordinator, (goal (holding circle))
//
// Failure: not-understood, with the word that is to blame and the nearest that is known.

#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra::forms {

struct Sentence {
  std::string agent;
  Datum operation;
};

Result<Sentence> read_sentence(std::string_view text);

}  // namespace pizarra::forms
