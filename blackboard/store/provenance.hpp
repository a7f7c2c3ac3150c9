#pragma once

// Because of what a fact was told: the fact, its reasons and theirs, as far as they stand. They are facts that are made
// up for each who asks, alone:
//
//   (provenance ROOT ID FACT TELLER WHEN BECAUSE)
//
// ROOT is the number of the fact that is asked about, and has to be said. FACT has the number ID; one of them is ROOT's
// own. BECAUSE are the numbers of its reasons. The nearest come first, 200 facts of 256 kB together at most.
//
//   if (asks_for(query, provenance)) answers = provenance_of(query, store, asked, examined);

#include "blackboard/store/made_up.hpp"

namespace pizarra::store {

class Store;

// Failures as of answer_from(), and bad-query where ROOT is not said.
Result<Answers> provenance_of(const Query& query, const Store& store, const AskedAt& asked, std::size_t& examined);

}  // namespace pizarra::store
