#include "blackboard/query.hpp"

#include <algorithm>
#include <array>

namespace pizarra {

namespace {

constexpr std::array<std::string_view, 6> comparisons = {"<", "<=", ">", ">=", "=", "/="};
constexpr std::size_t max_clauses = 64;

std::unexpected<Failure> bad_query(std::string sentence, const Datum& subject) {
  return fail("bad-query", std::move(sentence), subject);
}

bool is_comparison(const Datum& form) {
  return std::find(comparisons.begin(), comparisons.end(), form.head()) != comparisons.end();
}

Result<void> read_clause(const Datum& form, Query& query) {
  if (form.is_form("not")) {
    if (form.size() != 2) return bad_query("not takes one pattern", form);
    query.clauses.push_back({Query::Clause::Kind::absent, form[1]});
  } else if (is_comparison(form)) {
    query.clauses.push_back({Query::Clause::Kind::compare, form});
  } else {
    query.clauses.push_back({Query::Clause::Kind::fact, form});
  }
  return {};
}

std::unexpected<Failure> too_many_clauses(const Datum& subject) {
  return bad_query("a query has at most " + std::to_string(max_clauses) + " clauses", subject);
}

Result<void> read_body(const Datum& form, Query& query) {
  if (!form.is_form("and")) return read_clause(form, query);
  if (form.size() - 1 > max_clauses) return too_many_clauses(form[0]);
  for (const Datum& clause : form.items().subspan(1)) {
    Result<void> read = read_clause(clause, query);
    if (!read) return read;
  }
  return {};
}

Result<void> read_moment(const Datum& form, Query& query) {
  const bool timed = form.is_form("time") && form.size() == 2;
  const Datum& number = timed ? form[1] : form;
  if (!number.is_integer() || number.integer() < 0) {
    return bad_query("a moment is a revision or (time MICROSECONDS)", form);
  }
  Moment moment;
  if (timed) moment.time = Time(Duration(number.integer()));
  if (!timed) moment.revision = static_cast<Revision>(number.integer());
  query.at = moment;
  return {};
}

Result<void> read_option(const Datum& form, Query& query) {
  const bool given = (form.is_form("order") && !query.order.empty()) || (form.is_form("limit") && query.limit) ||
                     (form.is_form("at") && query.at);
  if (given) return bad_query("an option is given once", form);
  if (form.is_form("order") && form.size() == 2) {
    query.descending = form[1].is_form("down") && form[1].size() == 2;
    const Datum& variable = query.descending ? form[1][1] : form[1];
    if (!is_variable(variable)) return bad_query("order takes ?VARIABLE or (down ?VARIABLE)", form);
    query.order = variable.text();
    return {};
  }
  if (form.is_form("limit") && form.size() == 2 && form[1].is_integer() && form[1].integer() >= 0) {
    query.limit = static_cast<std::size_t>(form[1].integer());
    return {};
  }
  if (form.is_form("at") && form.size() == 2) return read_moment(form[1], query);
  return bad_query("a query's options are (order ?VARIABLE) or (order (down ?VARIABLE)), (limit COUNT) and (at MOMENT)",
                   form);
}

using Variables = std::vector<Datum>;

void collect_variables(const Datum& pattern, Variables& variables) {
  const bool fresh = is_variable(pattern) && std::ranges::find(variables, pattern) == variables.end();
  if (fresh) variables.push_back(pattern);
  for (const Datum& item : pattern.items()) collect_variables(item, variables);
}

Result<void> check_comparison(const Datum& form, const Variables& bound) {
  if (!is_comparison(form) || form.size() != 3) return bad_query("a comparison takes two operands", form);
  const bool of_numbers = form.head() != "=" && form.head() != "/=";
  for (const Datum& operand : form.items().subspan(1)) {
    Variables variables;
    collect_variables(operand, variables);
    for (const Datum& variable : variables) {
      if (std::ranges::find(bound, variable) != bound.end()) continue;
      return bad_query("a comparison uses " + std::string(variable.text()) + ", which no earlier pattern binds", form);
    }
    if (of_numbers && !is_variable(operand) && !operand.is_number()) {
      return bad_query("only numbers have an order", form);
    }
  }
  return {};
}

Result<void> check_pattern(const Datum& pattern) {
  if (pattern.head().empty() || is_variable(pattern[0])) {
    return bad_query("a pattern is a list that begins with a relation's name", pattern);
  }
  if (is_comparison(pattern) || pattern.is_form("not") || pattern.is_form("and") || pattern.is_form("query")) {
    return bad_query("this form cannot stand here", pattern);
  }
  return {};
}

}  // namespace

Result<void> check_query(const Query& query) {
  if (query.clauses.empty()) return bad_query("a query needs a clause", list("and"_sym));
  if (query.clauses.size() > max_clauses) return too_many_clauses({});
  const bool lone_pattern =
      query.clauses.size() == 1 && query.clauses[0].kind == Query::Clause::Kind::fact && query.order.empty();
  if (lone_pattern) return check_pattern(query.clauses[0].form);
  Variables bound;
  for (const Query::Clause& clause : query.clauses) {
    const bool compares = clause.kind == Query::Clause::Kind::compare;
    const Result<void> checked = compares ? check_comparison(clause.form, bound) : check_pattern(clause.form);
    if (!checked) return checked;
    if (clause.kind == Query::Clause::Kind::fact) collect_variables(clause.form, bound);
    std::erase(bound, "?"_sym);
  }
  const auto is_order = [&](const Datum& variable) { return variable.text() == query.order; };
  if (!query.order.empty() && std::ranges::none_of(bound, is_order)) {
    return bad_query("the answers are ordered by " + query.order + ", which no pattern binds",
                     Datum::symbol(query.order));
  }
  return {};
}

Query query_for(Datum pattern) {
  Query query;
  query.clauses.push_back({Query::Clause::Kind::fact, std::move(pattern)});
  return query;
}

Result<Query> query_from_datum(const Datum& form) {
  Query query;
  if (form.is_form("query")) {
    if (form.size() < 2) return bad_query("a query is (query BODY OPTION ...)", form);
    Result<void> read = read_body(form[1], query);
    if (!read) return fail(read);
    for (const Datum& option : form.items().subspan(2)) {
      read = read_option(option, query);
      if (!read) return fail(read);
    }
  } else {
    const Result<void> read = read_body(form, query);
    if (!read) return fail(read);
  }
  const Result<void> checked = check_query(query);
  if (!checked) return fail(checked);
  return query;
}

Datum query_to_datum(const Query& query) {
  std::vector<Datum> body = {"and"_sym};
  for (const Query::Clause& clause : query.clauses) {
    const bool absent = clause.kind == Query::Clause::Kind::absent;
    body.push_back(absent ? list("not"_sym, clause.form) : clause.form);
  }
  Datum form = body.size() == 2 ? body[1] : Datum::list(std::move(body));
  if (query.order.empty() && !query.limit && !query.at) return form;
  std::vector<Datum> whole = {"query"_sym, std::move(form)};
  if (!query.order.empty()) {
    const Datum variable = Datum::symbol(query.order);
    whole.push_back(list("order"_sym, query.descending ? list("down"_sym, variable) : variable));
  }
  if (query.limit) whole.push_back(list("limit"_sym, *query.limit));
  if (query.at) {
    const bool timed = query.at->time != Time::max();
    const Datum time = list("time"_sym, query.at->time.time_since_epoch().count());
    whole.push_back(list("at"_sym, timed ? time : to_datum(query.at->revision)));
  }
  return Datum::list(std::move(whole));
}

}  // namespace pizarra
