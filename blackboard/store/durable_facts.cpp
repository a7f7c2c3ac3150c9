#include "blackboard/store/durable_facts.hpp"

#include <algorithm>

namespace pizarra::store {

std::vector<std::pair<Fact, Restored>> durable_facts(const Store& store) {
  using As = Restored;
  std::vector<std::pair<Fact, As>> facts;
  for (const auto& [name, table] : store.tables()) {
    if (!table.relation().durable) continue;
    for (const StandingFact& standing : table.facts()) {
      facts.emplace_back(standing.fact, standing.lease != 0 ? As::leased : As::standing);
    }
  }
  for (auto& [fact, leased] : store.taken()) {
    const auto table = store.tables().find(fact.datum.head());
    if (table->second.relation().durable) facts.emplace_back(fact, leased ? As::taken_leased : As::taken);
  }
  std::ranges::sort(facts, {}, [](const auto& entry) { return entry.first.id; });
  return facts;
}

}  // namespace pizarra::store
