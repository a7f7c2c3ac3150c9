#include "agents/planner/distance/compact_problem.hpp"

#include <algorithm>

namespace pizarra::planner {

CompactProblem::CompactProblem(const Problem& problem)
    : facts_(problem.facts.size()), initials_(problem.initials), goals_(problem.goals) {
  for (const GroundAction& action : problem.actions) {
    preconditions_.add(action.preconditions);
    adds_.add(action.adds);
    deletes_.add(action.deletes);
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

}  // namespace pizarra::planner
