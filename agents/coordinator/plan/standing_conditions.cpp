#include "agents/coordinator/plan/standing_conditions.hpp"

#include <algorithm>
#include <iterator>

#include "lisp/forms/goal_formula.hpp"

namespace pizarra::coordinator {

std::vector<Datum> missing_from(const Facts& beliefs, const Facts& needed) {
  std::vector<Datum> missing;
  std::ranges::copy_if(needed, std::back_inserter(missing),
                       [&](const Datum& literal) { return !forms::literal_holds(literal, beliefs); });
  return missing;
}

void StandingConditions::begin(const GroundOperation& operation, const Facts& needed_after) {
  preconditions_ = Facts(operation.preconditions.begin(), operation.preconditions.end());
  throughout_ = needed_after;
  // What it provides or changes itself.
  for (const std::vector<Datum>* changed : {&operation.adds, &operation.deletes}) {
    for (const Datum& fact : *changed) {
      throughout_.erase(fact);
      throughout_.erase(list("not"_sym, fact));
    }
  }
  committed_ = false;
}

Result<void> StandingConditions::check(const Facts& beliefs) const {
  if (interruption_.raised()) return interruption_.failure();
  std::vector<Datum> lost = missing_from(beliefs, throughout_);
  if (!committed_) {
    for (const Datum& fact : preconditions_) {
      if (!beliefs.contains(fact) && !throughout_.contains(fact)) lost.push_back(fact);
    }
  }
  if (lost.empty()) return {};
  return fail("difference", "a condition of the operation or of the rest of the plan does not hold any more",
              Datum::list(std::move(lost)));
}

}  // namespace pizarra::coordinator
