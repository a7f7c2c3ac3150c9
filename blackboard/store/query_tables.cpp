#include "blackboard/store/query_tables.hpp"

#include "blackboard/boards_own.hpp"
#include "blackboard/limits.hpp"
#include "lisp/nearest.hpp"
#include "lisp/shortened.hpp"

namespace pizarra::store {

namespace {

Weight weigh(const Query& query) {
  constexpr std::size_t envelope = 64;
  Weight whole;
  for (const Query::Clause& clause : query.clauses) {
    whole += pizarra::weigh(clause.form);
    whole.bytes += envelope;
    whole.elements += 4;
  }
  return whole;
}

}  // namespace

Result<const FactTable*> table_named_by(const Datum& pattern, const Tables& tables) {
  const auto found = tables.find(pattern.head());
  if (found != tables.end()) return &found->second;
  if (pattern.head().empty()) return fail("wrong-shape", "a fact is a list that begins with a symbol", pattern);
  if (is_made_up(pattern.head())) {
    return fail("not-permitted",
                std::string(pattern.head()) + " says what is now: it can be asked for, alone, and nothing else",
                Datum::symbol(pattern.head()));
  }
  return fail("undeclared-relation", "no relation is called " + shortened(pattern.head(), limits::name_bytes),
              Datum::symbol(pattern.head()));
}

Result<const FactTable*> table_for(const Datum& pattern, const Tables& tables) {
  Result<const FactTable*> table = table_named_by(pattern, tables);
  if (!table) return table;
  const Result<void> fits = check_pattern_shape((*table)->relation(), pattern);
  if (!fits) return fail(fits);
  return table;
}

Result<void> check_query_on(const Query& query, const Tables& tables) {
  Result<void> checked = check_query(query);
  if (!checked) return checked;
  checked = check_weight(weigh(query), "a query");
  if (!checked) return checked;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    const Result<const FactTable*> table = table_for(clause.form, tables);
    if (!table) return fail(table);
  }
  return {};
}

Failure with_nearest(Failure failure, const Tables& tables, const std::function<bool(std::string_view)>& may_know,
                     std::size_t& examined) {
  constexpr std::size_t looks_a_name = 4;
  if (failure.symbol != "undeclared-relation" || !failure.subject.is_symbol()) return failure;
  const bool missed_in_the_past = tables.contains(failure.subject.text());
  if (missed_in_the_past) return failure;
  examined += looks_a_name * tables.size();
  std::vector<std::string_view> names;
  for (const auto& [name, table] : tables) {
    if (may_know(name)) names.push_back(name);
  }
  const std::string nearest = nearest_name(failure.subject.text(), names);
  if (!nearest.empty()) failure.sentence += "; did you mean " + nearest + "?";
  return failure;
}

}  // namespace pizarra::store
