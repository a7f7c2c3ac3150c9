#pragma once

// Reads and writes the numbers that facts are full of, whole ones and those with few digits behind their point, several
// times quicker than the library does; the same value and the same text. What is not of these is the library's.
//
//   Datum number;
//   if (!read_decimal("112.25", number)) ...;          // from_chars
//   char buffer[longest_decimal];
//   if (char* end = write_decimal(buffer, 112.25)) ...; // else to_chars

#include <cstddef>
#include <string_view>

#include "lisp/datum.hpp"

namespace pizarra {

inline constexpr std::size_t longest_decimal = 24;

// An integer or real; whether `token` is one of at most 15 digits without an exponent, digits on both sides of a point.
bool read_decimal(std::string_view token, Datum& number);

// The end of what was written, with a point and a digit behind it; null where the value has more than three digits
// there, or is written with an exponent.
char* write_decimal(char* out, double value);

}  // namespace pizarra
