#include "agents/coordinator/perceive/beliefs.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra::coordinator {

Beliefs::Change Beliefs::perceive(const Facts& perceived, Evidence shown_by) {
  Facts differing;
  std::ranges::set_symmetric_difference(believed_, perceived, std::inserter(differing, differing.end()));
  std::erase_if(doubts_, [&](const auto& doubt) { return !differing.contains(doubt.first); });
  Change change;
  for (const Datum& fact : differing) {
    if (++doubts_[fact] < patience_) continue;
    doubts_.erase(fact);
    changed_in_.insert_or_assign(fact, shown_by);
    if (believed_.erase(fact) > 0) {
      change.gone.push_back(fact);
    } else {
      believed_.insert(fact);
      change.come.push_back(fact);
    }
  }
  return change;
}

Beliefs::Evidence Beliefs::changed_in(const Datum& fact) const {
  const auto it = changed_in_.find(fact);
  return it == changed_in_.end() ? Evidence() : it->second;
}

}  // namespace pizarra::coordinator
