#pragma once

// The bytes of which the language is made, and where a byte of a text stands for a person.
//
//   is_symbol_char('>');                      // true
//   begins_like_number("-.5");                // true
//   place_of("cell.scm", text, offset);       // "cell.scm:3:7", that line, and a caret under it

#include <array>
#include <cstddef>
#include <string>
#include <string_view>

namespace pizarra {

inline constexpr std::array<bool, 256> symbol_chars = [] {
  std::array<bool, 256> out{};
  for (unsigned c = '0'; c <= '9'; ++c) out[c] = true;
  for (unsigned c = 'a'; c <= 'z'; ++c) out[c] = out[c - 'a' + 'A'] = true;
  for (const char c : std::string_view("!$%&*/:<=>?^_~+-.@")) out[static_cast<unsigned char>(c)] = true;
  return out;
}();

// Whether a symbol may hold this byte.
inline bool is_symbol_char(char c) { return symbol_chars[static_cast<unsigned char>(c)]; }
// Whether what begins so is a number or nothing: a digit, or a sign or point before a digit.
constexpr bool begins_like_number(std::string_view token) {
  if (!token.empty() && (token.front() == '+' || token.front() == '-')) token.remove_prefix(1);
  if (!token.empty() && token.front() == '.') token.remove_prefix(1);
  return !token.empty() && token.front() >= '0' && token.front() <= '9';
}
// The bytes of the UTF-8 sequence that begins here, 0 where none does (overlong forms and surrogates are none).
std::size_t utf8_length(std::string_view text);

// "file:line:column" of the byte at `offset`, then its line and a caret under it. Lines and columns count from 1 and
// columns are characters. Of a long line only the part around the caret is shown.
std::string place_of(std::string_view file, std::string_view text, std::size_t offset);

}  // namespace pizarra
