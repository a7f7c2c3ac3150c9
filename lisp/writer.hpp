#pragma once

// Datum to text, exactly: reading what was written gives an equal datum, on any machine. A real is written with the
// fewest digits that read back to the same double and always with a point or an exponent.
//
//   std::string line = "(";
//   write_string_to(line, "vision");        // as a string, without making a datum of it
//   write_number_to(line += ' ', 7);
//   write_to(line += ' ', fact);

#include <array>
#include <charconv>
#include <concepts>
#include <string>
#include <string_view>

#include "lisp/datum.hpp"

namespace pizarra {

std::string write(const Datum& datum);
void write_to(std::string& out, const Datum& datum);
void write_string_to(std::string& out, std::string_view text);

inline void write_number_to(std::string& out, std::integral auto number) {
  std::array<char, 24> digits;
  out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr);
}

}  // namespace pizarra
