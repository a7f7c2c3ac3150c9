#pragma once

// Text of devices, files and people without the blanks around it, and in lower case (of ASCII; other bytes stay).

#include <algorithm>
#include <string>
#include <string_view>

namespace pizarra {

inline constexpr std::string_view blanks = " \t\r\n\f\v";

constexpr std::string_view trimmed(std::string_view text) {
  const std::size_t begin = std::min(text.find_first_not_of(blanks), text.size());
  return text.substr(begin, text.find_last_not_of(blanks) + 1 - begin);
}

inline std::string lowered(std::string_view text) {
  std::string out(text);
  std::ranges::transform(out, out.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c | 32) : c; });
  return out;
}

}  // namespace pizarra
