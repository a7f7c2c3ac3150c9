#pragma once

// Text as other programs read it: JSON, for the words that answer `--json`.
//
//   fmt::print("{{\"fact\":{}}}\n", json_string(write(fact)));
//   json_error(failure)     {"error":{"symbol":"unknown-agent","sentence":"...","subject":"robot"}}

#include <string>
#include <string_view>

#include "lisp/result.hpp"

namespace pizarra {

// A JSON string, quotes included.
std::string json_string(std::string_view text);

// The inside of a failure alone, and the whole object. There is a "place" where text was read.
std::string json_failure(const Failure& failure);
std::string json_error(const Failure& failure);

}  // namespace pizarra
