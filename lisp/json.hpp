#pragma once

// Text as other programs read it: JSON, for the words that answer `--json`.
//
//   fmt::print("{{\"fact\":{}}}\n", json_string(write(fact)));

#include <string>
#include <string_view>

namespace pizarra {

// A JSON string, quotes included.
std::string json_string(std::string_view text);

}  // namespace pizarra
