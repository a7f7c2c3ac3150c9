#pragma once

// The range that comparisons leave for each argument, so that an index finds the facts in it alone: the range in which
// each argument must lie that is compared with something known, so that an index finds those facts alone.
//
//   std::vector<ValueRange> ranges;
//   narrow(ranges, pattern, comparison);      // (seen ?name ?x) and (< ?x 200): argument 1 up to 200

#include <optional>
#include <vector>

#include "blackboard/store/ordered_index.hpp"

namespace pizarra::store {

// The argument of the pattern that is this variable, if any.
std::optional<std::size_t> argument_of(const Datum& variable, const Datum& pattern);

// By a comparison in which what is bound stands already. One that says nothing of an argument narrows nothing.
void narrow(std::vector<ValueRange>& ranges, const Datum& pattern, const Datum& comparison);

}  // namespace pizarra::store
