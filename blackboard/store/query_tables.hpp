#pragma once

// Finds the tables that a pattern or a query is about, and checks it against them. Failures undeclared-relation,
// wrong-shape, bad-query and too-large; not-permitted for what only the board says.
//
//   Result<const FactTable*> table = table_for(pattern, tables);
//   Result<void> checked = check_query_on(query, tables);
//   if (!checked) return fail(with_nearest(checked.error(), tables, may_know, examined));     // to whoever asked

#include <functional>
#include <string_view>

#include "blackboard/query.hpp"
#include "blackboard/store/fact_table.hpp"

namespace pizarra::store {

// The table of the relation that the pattern is about, whatever its shape.
Result<const FactTable*> table_named_by(const Datum& pattern, const Tables& tables);
// The same, and the pattern has the relation's shape.
Result<const FactTable*> table_for(const Datum& pattern, const Tables& tables);

// Whether the query is well made and its patterns fit declared relations.
Result<void> check_query_on(const Query& query, const Tables& tables);

// The failure as it is told: where no relation is called so, with the nearest of those that whoever asked may know of.
// Adds to `examined` as many facts as could have been looked at meanwhile.
Failure with_nearest(Failure failure, const Tables& tables, const std::function<bool(std::string_view)>& may_know,
                     std::size_t& examined);

}  // namespace pizarra::store
