#pragma once

// What a join says of the facts that its patterns can be fitted by: in (and (role 7 ?s) (reading ?s ?v)) a reading
// concerns nobody but with an ?s that stands in a (role 7 ?s). The first pattern guards the other one, which is filed
// under the values that the guard's facts have for ?s, as long as these are few. A guard has a constant, and no guard;
// four patterns of a watch have one at most.
//
//   std::vector<WatchedPattern> patterns = patterns_of(query, watch);
//   guard_by_joins(query, patterns);
//   allow_what_stands(pattern, tables);                  // before each is added to its index
//
// What comes and goes of a guard's facts allows and disallows values (pattern_index.hpp).

#include <vector>

#include "blackboard/store/fact_table.hpp"
#include "blackboard/watch/pattern_index.hpp"

namespace pizarra::watch {

// The patterns are the query's, and stay where they are.
void guard_by_joins(const Query& query, std::vector<WatchedPattern>& patterns);

// Leaves a pattern unguarded whose guard's facts have too many values.
void allow_what_stands(WatchedPattern& pattern, const store::Tables& tables);

}  // namespace pizarra::watch
