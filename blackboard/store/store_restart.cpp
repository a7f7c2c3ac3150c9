// Removes, keeps or renews a store's facts when its board starts again, or another board takes over with them.

#include "blackboard/store/store.hpp"
#include "blackboard/store/store_change.hpp"

namespace pizarra::store {

void Store::resume(Time now) {
  Change change(*this, "board", now);
  for (auto& [name, table] : tables_) {
    std::vector<FactId> passing;
    for (const StandingFact& standing : table.facts()) {
      if (!table.relation().durable || standing.lease != 0) passing.push_back(standing.fact.id);
    }
    for (const FactId id : passing) change.retract(id);
    if (!table.relation().lease) continue;
    for (const StandingFact& standing : table.facts()) {
      const FactId id = standing.fact.id;
      table.find(id)->expiry = now + *table.relation().lease;
      fact_expiries_.emplace(now + *table.relation().lease, id);
    }
  }
  while (!held_.empty()) {
    const auto& [id, held] = *held_.begin();
    if (tables_.find(held.fact.datum.head())->second.relation().durable) {
      change.put_back(id);
    } else {
      change.settle(id);
    }
  }
  change.finish();
}

}  // namespace pizarra::store
