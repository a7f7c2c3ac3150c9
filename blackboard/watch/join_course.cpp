#include "blackboard/watch/join_course.hpp"

#include <algorithm>

namespace pizarra::watch {

namespace {

using Kind = Query::Clause::Kind;
using Variables = std::vector<Datum>;

bool contains(const Variables& variables, const Datum& variable) {
  return std::ranges::find(variables, variable) != variables.end();
}

void collect(const Datum& pattern, Variables& variables) {
  const bool named = is_variable(pattern) && pattern.text().size() > 1;
  if (named && !contains(variables, pattern)) variables.push_back(pattern);
  for (const Datum& item : pattern.items()) collect(item, variables);
}

Variables variables_of(const Datum& pattern) {
  Variables variables;
  collect(pattern, variables);
  return variables;
}

Variables bound_by_patterns(const Query& query) {
  Variables bound;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Kind::fact) collect(clause.form, bound);
  }
  return bound;
}

// Whether all that can be known of the form is: what no pattern binds never will be.
bool is_known(const Datum& form, const Variables& known, const Variables& bound) {
  return std::ranges::all_of(variables_of(form), [&](const Datum& variable) {
    return contains(known, variable) || !contains(bound, variable);
  });
}

// The more is known of a pattern, the fewer facts it is looked for among.
std::size_t knowledge_of(const Datum& pattern, const Variables& known, const store::FactTable& table) {
  const auto is_fixed = [&](std::size_t position) {
    const Datum& argument = pattern[position + 1];
    return !argument.is_symbol("?") && std::ranges::all_of(variables_of(argument), [&](const Datum& variable) {
      return contains(known, variable);
    });
  };
  std::size_t fixed = 0;
  for (std::size_t position = 0; position + 1 < pattern.size(); ++position) fixed += is_fixed(position) ? 1 : 0;
  const bool one_at_most = std::ranges::all_of(table.relation().key, is_fixed);
  return one_at_most ? pattern.size() : fixed;
}

}  // namespace

Query with_own_variables(Query query) {
  Variables taken;
  for (const Query::Clause& clause : query.clauses) collect(clause.form, taken);
  Variables earlier;
  for (Query::Clause& clause : query.clauses) {
    if (clause.kind == Kind::fact) collect(clause.form, earlier);
    if (clause.kind != Kind::absent) continue;
    Bindings renamed;
    for (const Datum& variable : variables_of(clause.form)) {
      if (contains(earlier, variable)) continue;
      std::string name(variable.text());
      do name += '-';
      while (contains(taken, Datum::symbol(name)));
      taken.push_back(Datum::symbol(name));
      renamed.bind(variable, taken.back());
    }
    clause.form = substitute(clause.form, renamed);
  }
  return query;
}

std::vector<std::size_t> course_from(const Query& query, std::size_t clause, const store::Tables& tables) {
  const Variables bound = bound_by_patterns(query);
  Variables known = variables_of(query.clauses[clause].form);
  std::vector<std::size_t> left;
  for (std::size_t i = 0; i < query.clauses.size(); ++i) {
    if (i != clause) left.push_back(i);
  }
  std::vector<std::size_t> course;
  const auto knowledge = [&](std::size_t i) -> std::size_t {
    const auto& [kind, form] = query.clauses[i];
    if (kind == Kind::fact) return 1 + knowledge_of(form, known, tables.find(form.head())->second);
    return is_known(form, known, bound) ? ~std::size_t{0} : 0;
  };
  while (!left.empty()) {
    const auto next = std::ranges::max_element(left, {}, knowledge);
    course.push_back(*next);
    collect(query.clauses[*next].form, known);
    left.erase(next);
  }
  return course;
}

Bindings shared_bindings(const Query& query, const Bindings& bindings) {
  const Variables bound = bound_by_patterns(query);
  Bindings shared;
  for (const auto& [variable, value] : bindings.all()) {
    if (contains(bound, variable)) shared.bind(variable, value);
  }
  return shared;
}

}  // namespace pizarra::watch
