#pragma once

// The characters that stand behind a backslash in a written string.
//
//   if (needs_escape(c)) out += '\\';

#include <array>

namespace pizarra {

inline constexpr std::array<bool, 256> escaped_bytes = [] {
  std::array<bool, 256> out{};
  out['"'] = out['\\'] = out['\n'] = out['\t'] = true;
  return out;
}();

constexpr bool needs_escape(char c) { return escaped_bytes[static_cast<unsigned char>(c)]; }

}  // namespace pizarra
