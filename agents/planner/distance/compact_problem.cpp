#include "agents/planner/distance/compact_problem.hpp"

#include <algorithm>

namespace pizarra {

namespace {

void add_row(Rows& rows, const std::vector<std::size_t>& wide, std::vector<std::uint32_t>& row) {
  row.clear();
  for (const std::size_t item : wide) row.push_back(static_cast<std::uint32_t>(item));
  rows.add(row);
}

}  // namespace

Rows transposed(const Rows& rows, std::size_t size) {
  std::vector<std::vector<std::uint32_t>> lists(size);
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (const std::uint32_t item : rows[row]) lists[item].push_back(static_cast<std::uint32_t>(row));
  }
  Rows out;
  for (const std::vector<std::uint32_t>& list : lists) out.add(list);
  return out;
}

CompactProblem::CompactProblem(const Problem& problem)
    : facts_(problem.facts.size()), initials_(problem.initials), goals_(problem.goals) {
  std::vector<std::uint32_t> row;
  for (const GroundAction& action : problem.actions) {
    add_row(preconditions_, action.preconditions, row);
    add_row(adds_, action.adds, row);
    add_row(deletes_, action.deletes, row);
  }
  needing_ = transposed(preconditions_, facts_);
  adding_ = transposed(adds_, facts_);
  deleting_ = transposed(deletes_, facts_);

  std::vector<std::vector<ActionIndex>> keyed(facts_);
  for (ActionIndex action = 0; action < actions(); ++action) {
    const auto rarest =
        std::ranges::min_element(preconditions(action), {}, [&](FactIndex fact) { return needing(fact).size(); });
    if (rarest == preconditions(action).end()) {
      keyless_.push_back(action);
    } else {
      keyed[*rarest].push_back(action);
    }
  }
  for (const std::vector<ActionIndex>& list : keyed) keyed_.add(list);
}

}  // namespace pizarra
