#pragma once

// How a query compares: numbers by value, whichever kind they are; everything else as Datum orders it.
//
//   compare_values(to_datum(1), to_datum(1.0)) == 0

#include <compare>

#include "lisp/datum.hpp"

namespace pizarra::store {

std::strong_ordering compare_values(const Datum& a, const Datum& b);

}  // namespace pizarra::store
