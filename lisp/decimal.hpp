#pragma once

// Reads and writes the numbers that facts are full of, whole ones and those with few digits behind their point, several
// times quicker than the library does; the same value and the same text. Other numbers are left to the library.
//
//   Decimal read = read_decimal("112.25)");
//   if (read.length == 0) ...;                          // from_chars
//   char buffer[longest_decimal];
//   if (char* end = write_decimal(buffer, 112.25)) ...; // else to_chars

#include <cstddef>
#include <string_view>

#include "lisp/datum.hpp"

namespace pizarra {

inline constexpr std::size_t longest_decimal = 24;

// A text's first bytes as the number that they are.
struct Decimal {
  Datum number;
  std::size_t length = 0;
};

// The number that `text` begins with, up to a byte that no symbol holds: a whole one of at most 18 digits, or one with
// digits on both sides of its point, 15 in all. No length where it is none of these.
Decimal read_decimal(std::string_view text);

// The end of what was written, with a point and a digit behind it; null where the value has more than three digits
// there, or is written with an exponent.
char* write_decimal(char* out, double value);

}  // namespace pizarra
