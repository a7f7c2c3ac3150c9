#pragma once

// The beginning of a text that may be long, enough to recognise it, cut between two characters of UTF-8.
//
//   shortened("a very long sentence", 6)       // "a very..."

#include <string>
#include <string_view>

namespace pizarra {

inline std::string shortened(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return std::string(text);
  std::size_t end = bytes;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return std::string(text.substr(0, end)) + "...";
}

}  // namespace pizarra
