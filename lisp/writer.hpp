#pragma once

// Datum to text, exactly: reading what was written gives an equal datum, on any machine. A real is written with the
// fewest digits that read back to the same double and always with a point or an exponent.

#include <string>

#include "lisp/datum.hpp"

namespace pizarra {

std::string write(const Datum& datum);
void write_to(std::string& out, const Datum& datum);

}  // namespace pizarra
