#pragma once

// `check` of agents that are Scheme files, and of the stories that they are tried on.
//
//   if (is_agent_file(text)) return check_agent(file);

#include <string>

#include "lisp/reader.hpp"

namespace pizarra::programs {

// By its first form; the text is Scheme, which the strict reader need not know.
bool is_agent_file(std::string_view text);
// Loads it as the agent does. Failures: those of forms::AgentProgram, and of a contract that would be refused.
Result<std::string> check_agent(const std::string& file, const std::string& text);

bool is_agent_story(const Source& source);
Result<std::string> check_agent_story(const Source& source);

}  // namespace pizarra::programs
