#pragma once

// Answers a query from tables of facts: clauses are joined in the order they are written, each through the indexes of
// its relation. At most a million facts are looked at, and the answers must fit a frame: failure too-large otherwise.
//
//   Result<void> checked = check_query_on(query, tables);         // bad-query, undeclared-relation, wrong-shape
//   Result<std::vector<Answer>> answers = evaluate(query, tables);

#include "blackboard/fact_table.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/query.hpp"

namespace pizarra {

// The table of the relation that the pattern is about, whose shape the pattern has.
Result<const FactTable*> table_for(const Datum& pattern, const Tables& tables);

// Whether the query is well made and its patterns fit declared relations.
Result<void> check_query_on(const Query& query, const Tables& tables);

// The query must have been checked. With `pinned`, only the answers in which the query's positive patterns, of which
// there must be one, match that fact, whether or not it stands.
Result<std::vector<Answer>> evaluate(const Query& query, const Tables& tables, const Fact* pinned = nullptr);

// Whether a comparison of values that are all bound is true.
bool holds(const Datum& comparison, const Bindings& bindings);

Weight weigh(const Answer& answer);

}  // namespace pizarra
