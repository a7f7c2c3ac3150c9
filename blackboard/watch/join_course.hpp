#pragma once

// In which order the other clauses of a query are best satisfied when one of them is about a fact that is known: what
// can be decided is decided at once, then comes the pattern of which the most is known, its key above all.
//
//   const Query own = with_own_variables(query);
//   std::vector<std::size_t> course = course_from(own, clause, tables);      // the other clauses

#include <vector>

#include "blackboard/query.hpp"
#include "blackboard/store/fact_table.hpp"

namespace pizarra::watch {

// The same query whose clauses may be satisfied in any order: the variables that stand for "any" in a `not`, because no
// earlier pattern binds them, are called like none of another clause.
Query with_own_variables(Query query);

// Of a query with own variables, which has been checked on the tables.
std::vector<std::size_t> course_from(const Query& query, std::size_t clause, const store::Tables& tables);

// Those of a `not`'s bindings that other clauses know, too.
Bindings shared_bindings(const Query& query, const Bindings& bindings);

}  // namespace pizarra::watch
