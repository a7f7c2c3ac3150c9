#pragma once

// Text from a line, made fit to be told: at most 80 characters, those that cannot be printed by their numbers.
//
//   printable("\xff ok")      // "\\xff ok"

#include <algorithm>
#include <fmt/format.h>
#include <string>
#include <string_view>

namespace pizarra::line {

inline bool is_printable(char c) { return c >= 0x20 && c < 0x7f; }

inline bool is_printable(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return is_printable(c); });
}

inline std::string printable(std::string_view text) {
  std::string out;
  for (const char c : text.substr(0, 80)) {
    out += is_printable(c) ? std::string(1, c) : fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
  }
  return out;
}

}  // namespace pizarra::line
