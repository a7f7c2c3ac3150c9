#include "agents/coordinator/plan/vigil.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra::coordinator {

void Vigil::begin(const TriangleTable& table, std::size_t index) {
  const std::vector<Datum>& needed = table.plan()[index].preconditions;
  preconditions_ = Facts(needed.begin(), needed.end());
  throughout_ = table.kept_during(index);
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
