#pragma once

// All that is durable in a store, by ascending id: what Store::restore() takes to have it again, in another store.
//
//   for (auto& [fact, as] : durable_facts(store)) other.restore(std::move(fact), as);

#include <utility>
#include <vector>

#include "blackboard/store/store.hpp"

namespace pizarra::store {

std::vector<std::pair<Fact, Restored>> durable_facts(const Store& store);

}  // namespace pizarra::store
