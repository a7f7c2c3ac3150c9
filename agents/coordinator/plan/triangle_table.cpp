#include "agents/coordinator/plan/triangle_table.hpp"

#include <algorithm>

namespace pizarra::coordinator {

TriangleTable::TriangleTable(std::vector<GroundOperation> plan, const std::vector<Datum>& goal)
    : plan_(std::move(plan)), needed_(plan_.size() + 1) {
  needed_.back() = Facts(goal.begin(), goal.end());
  for (std::size_t i = plan_.size(); i-- > 0;) {
    needed_[i] = needed_[i + 1];
    for (const Datum& fact : plan_[i].adds) needed_[i].erase(fact);
    needed_[i].insert(plan_[i].preconditions.begin(), plan_[i].preconditions.end());
  }
}

Facts TriangleTable::kept_during(std::size_t index) const {
  Facts kept = needed_[index + 1];
  for (const Datum& fact : plan_[index].adds) kept.erase(fact);
  for (const Datum& fact : plan_[index].deletes) kept.erase(fact);
  return kept;
}

std::optional<std::size_t> TriangleTable::furthest(const Facts& facts) const {
  for (std::size_t i = needed_.size(); i-- > 0;) {
    if (std::ranges::includes(facts, needed_[i])) return i;
  }
  return std::nullopt;
}

}  // namespace pizarra::coordinator
