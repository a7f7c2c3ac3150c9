#pragma once

// Answers a query from tables of facts: patterns are joined in the order they are written, each through the indexes of
// its relation, by what is bound in it and by what its variables are compared with; a comparison is made as soon as its
// variables are bound. With an order by an argument of the first pattern and a limit, that relation is gone through in
// that order as far as the limit asks. At most limits::examined facts are looked at (failure too-costly), and the
// answers must fit a frame (too-large).
//
//   Result<void> checked = check_query_on(query, tables);         // query_tables.hpp
//   Result<std::vector<Answer>> answers = evaluate(query, tables);
//
// The answers that involve one fact are found from that fact on, the other clauses in an order of their own
// (join_course.hpp):
//
//   std::size_t examined = 0;
//   Result<std::vector<Answer>> with_it = evaluate_from({bindings, clause, &fact}, course, query, tables, examined);

#include <span>

#include "blackboard/limits.hpp"
#include "blackboard/query.hpp"
#include "blackboard/store/compare_values.hpp"
#include "blackboard/store/fact_table.hpp"

namespace pizarra::store {

// The query must have been checked.
Result<std::vector<Answer>> evaluate(const Query& query, const Tables& tables);
// Adds to `examined` how many facts were looked at.
Result<std::vector<Answer>> evaluate(const Query& query, const Tables& tables, std::size_t& examined);

// Everything that is settled before a search: variables, and the fact that a positive clause is to match, where there
// is one.
struct SearchStart {
  Bindings bindings;
  std::size_t clause = 0;
  const Fact* fact = nullptr;
};
// Every answer that begins so and satisfies the clauses of the course, by none but their order; the query's order and
// limit do not count. Adds to `examined` how many facts were looked at. Failures too-costly and too-large, as above.
Result<std::vector<Answer>> evaluate_from(SearchStart start, std::span<const std::size_t> course, const Query& query,
                                          const Tables& tables, std::size_t& examined);

// Whether a comparison of values that are all bound is true.
bool holds(const Datum& comparison, const Bindings& bindings);

Weight weigh(const Answer& answer);

}  // namespace pizarra::store
