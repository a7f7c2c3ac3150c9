#pragma once

// A query is a conjunction over facts with shared variables:
//
//   (on ?x ?y)
//   (and (on ?x ?y) (not (on ?z ?x)))
//   (and (seen ?name ?x ?y ?d) (< ?d 900))          ; < <= > >= = /= between numbers, variables; = /= between any data
//   (query (seen ?name ?x ?y ?d) (order ?x) (limit 2))   ; (order (down ?x)) for descending
//   (query (on ?x ?y) (at 120))                     ; what held at revision 120, of a board that keeps a journal
//   (query (on ?x ?y) (at (time 1500000)))          ; at that time, in microseconds
//
// A variable of a `not` or a comparison that no earlier positive pattern binds: in a comparison it is refused, in a
// `not` it stands for "any".

#include <optional>
#include <string>
#include <vector>

#include "blackboard/fact.hpp"
#include "lisp/pattern.hpp"
#include "lisp/result.hpp"

namespace pizarra {

struct Query {
  struct Clause {
    enum class Kind : std::uint8_t { fact, absent, compare };
    Kind kind;
    Datum form;  // the pattern, or the comparison whole
  };
  std::vector<Clause> clauses;
  std::string order;  // a variable, empty: by the facts' ids
  bool descending = false;
  std::optional<std::size_t> limit;
  std::optional<Moment> at;
};

Result<Query> query_from_datum(const Datum& form);
// Every fact that fits one pattern.
Query query_for(Datum pattern);
Datum query_to_datum(const Query& query);
// Whether a query that was put together in C++ is one: not too many clauses, every variable bound where it must be.
Result<void> check_query(const Query& query);

// One way to satisfy a query: the variables' values and the facts that the positive patterns matched, in their order.
struct Answer {
  Bindings bindings;
  std::vector<Fact> facts;
  bool operator==(const Answer&) const = default;
};

struct Answers {
  Revision revision = 0;
  std::vector<Answer> answers;
};

}  // namespace pizarra
