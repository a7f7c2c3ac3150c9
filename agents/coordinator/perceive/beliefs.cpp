#include "agents/coordinator/perceive/beliefs.hpp"

#include <algorithm>
#include <iterator>

namespace pizarra::coordinator {

Beliefs::Change Beliefs::perceive(const Facts& perceived) {
  Facts differing;
  std::ranges::set_symmetric_difference(believed_, perceived, std::inserter(differing, differing.end()));
  std::erase_if(doubts_, [&](const auto& doubt) { return !differing.contains(doubt.first); });
  Change change;
  for (const Datum& fact : differing) {
    if (++doubts_[fact] < patience_) continue;
    doubts_.erase(fact);
    if (believed_.erase(fact) > 0) {
      change.gone.push_back(fact);
    } else {
      believed_.insert(fact);
      change.come.push_back(fact);
    }
  }
  return change;
}

}  // namespace pizarra::coordinator
