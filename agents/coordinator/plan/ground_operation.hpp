#pragma once

// One operation of a plan with its variables replaced, and facts as they are compared.
//
//   const std::vector<Datum> missing = missing_from(beliefs, needed);     // {(clear circle), (not (holding square))}

#include <set>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::coordinator {

using Facts = std::set<Datum>;

// Those of `needed`, facts and (not FACT), that do not hold.
std::vector<Datum> missing_from(const Facts& beliefs, const Facts& needed);

struct GroundOperation {
  Datum name;  // (STACK circle triangle)
  std::vector<Datum> preconditions;
  std::vector<Datum> adds;
  std::vector<Datum> deletes;
};

}  // namespace pizarra::coordinator
