#pragma once

// How a query compares: numbers by value, whichever kind they are; everything else as Datum orders it.
//
//   compare_values(to_datum(1), to_datum(1.0)) == 0

#include <compare>

#include "lisp/datum.hpp"

namespace pizarra::store {

// The least real number above every integer; the least integer is its opposite.
inline constexpr double beyond_integers = 0x1p63;

std::strong_ordering compare_values(const Datum& a, const Datum& b);

}  // namespace pizarra::store
