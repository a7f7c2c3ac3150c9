#include "agents/coordinator/plan/vigil.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra::coordinator {

void Vigil::begin(const GroundOperation& operation, const Facts& needed_after) {
  preconditions_ = Facts(operation.preconditions.begin(), operation.preconditions.end());
  throughout_ = needed_after;
  // What it provides or changes itself.
  for (const Datum& fact : operation.adds) throughout_.erase(fact);
  for (const Datum& fact : operation.deletes) throughout_.erase(fact);
  committed_ = false;
}

Result<void> Vigil::check(const Facts& beliefs) const {
  if (interrupted_) return fail("interrupted", "another goal, or none, is wanted now");
  std::vector<Datum> lost;
  std::ranges::set_difference(throughout_, beliefs, std::back_inserter(lost));
  if (!committed_) {
    for (const Datum& fact : preconditions_) {
      if (!beliefs.contains(fact) && !throughout_.contains(fact)) lost.push_back(fact);
    }
  }
  if (lost.empty()) return {};
  return fail("difference", "what the operation and the rest of the plan need does not hold any more",
              Datum::list(std::move(lost)));
}

}  // namespace pizarra::coordinator
