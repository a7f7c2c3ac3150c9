#pragma once

// Tries a Scheme agent on a story, on a board of its own in virtual time: what it is told, and what is expected of it.
//
//   (declare (relation barrier ((name symbol) (state symbol)) (key name)))   ; what others tell
//   (tell (barrier exit blocked))
//   (expect (belt stopped))                 ; holds within a second
//   (absent (jam ?))                        ; does not hold
//   (call (count) (1))                      ; the agent's operation answers (ok 1); (call OP fails) that it fails
//   (retract (barrier exit ?))
//   (wait 500)                              ; milliseconds
//
//   std::vector<std::string> wrong = try_agent("conveyor", "conveyor.scm", story);    // empty: all was as expected

#include "agents/scheme/scheme_agent.hpp"
#include "lisp/reader.hpp"

namespace pizarra::programs {

// Failures: those of a form that is none of these. Answers whatever was not as expected, each with its line.
Result<std::vector<std::string>> try_agent(const std::string& name, scheme::SchemeOptions options, const Source& story);

}  // namespace pizarra::programs
