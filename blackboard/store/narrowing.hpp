#pragma once

// The range that a query's comparisons with known values leave for each argument of a pattern, so that an index finds
// the facts in that range alone.
//
//   std::vector<ValueRange> ranges;
//   narrow(ranges, pattern, comparison);      // (seen ?name ?x) and (< ?x 200): argument 1 up to 200

#include <optional>
#include <vector>

#include "blackboard/store/ordered_index.hpp"

namespace pizarra::store {

// The argument of the pattern that is this variable, if any.
std::optional<std::size_t> argument_of(const Datum& variable, const Datum& pattern);

// By a comparison whose bound variables are replaced by their values. One about no argument narrows nothing.
void narrow(std::vector<ValueRange>& ranges, const Datum& pattern, const Datum& comparison);

}  // namespace pizarra::store
