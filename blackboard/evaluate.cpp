#include "blackboard/evaluate.hpp"

#include <algorithm>
#include <utility>

#include "lisp/nearest.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

// An answer that is to be ordered and cut to a limit may pass through this many frames' worth of others.
constexpr std::size_t frames_to_sort = 64;

// Numbers by value, whichever kind they are; everything else as Datum orders it.
std::partial_ordering compare_values(const Datum& a, const Datum& b) {
  if (a.is_integer() && b.is_integer()) return a.integer() <=> b.integer();
  if (a.is_number() && b.is_number()) return a.number() <=> b.number();
  return a <=> b;
}

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

class Search {
 public:
  Search(const Query& query, const Tables& tables, const Fact* pinned)
      : query_(query), tables_(tables), pinned_(pinned), enough_(query.order.empty() ? query.limit : std::nullopt) {
    weight_bound_ = limits::bytes;
    if (!query.order.empty() && query.limit) weight_bound_ *= frames_to_sort;
  }

  Result<std::vector<Answer>> run() {
    if (query_.limit != 0U) extend(0, {});
    if (examined_ > limits::examined) {
      return fail("too-large", "answering this takes looking at more than a million facts", query_to_datum(query_));
    }
    if (weight_.bytes > weight_bound_) return too_many();
    if (!query_.order.empty()) sort();
    if (query_.limit && answers_.size() > *query_.limit) cut();
    if (!check_weight(weight_, "the answer")) return too_many();
    return std::move(answers_);
  }

 private:
  std::unexpected<Failure> too_many() const {
    return fail("too-large", "the answers are more than fit one message", query_to_datum(query_));
  }

  // Whether the search should go on.
  bool extend(std::size_t clause, Bindings bindings) {
    if (clause == query_.clauses.size()) return finish(std::move(bindings));
    const Query::Clause& next = query_.clauses[clause];
    switch (next.kind) {
      case Query::Clause::Kind::compare:
        return !holds(next.form, bindings) || extend(clause + 1, std::move(bindings));
      case Query::Clause::Kind::absent:
        return exists(substitute(next.form, bindings)) || extend(clause + 1, std::move(bindings));
      case Query::Clause::Kind::fact:
        return extend_by_fact(clause, bindings);
    }
    return false;
  }

  bool extend_by_fact(std::size_t clause, const Bindings& bindings) {
    const Datum& form = query_.clauses[clause].form;
    bool go_on = true;
    const auto consider = [&](const Fact& fact) {
      if (++examined_ > limits::examined) return go_on = false;
      Bindings both = bindings;
      if (!match(form, fact.datum, both)) return true;
      chosen_.push_back(&fact);
      go_on = extend(clause + 1, std::move(both));
      chosen_.pop_back();
      return go_on;
    };
    if (pinned_ != nullptr) {
      consider(*pinned_);
    } else if (bindings.all().empty()) {
      tables_.find(form.head())->second.visit(form, consider);
    } else {
      tables_.find(form.head())->second.visit(substitute(form, bindings), consider);
    }
    return go_on;
  }

  bool exists(const Datum& pattern) {
    bool found = false;
    tables_.find(pattern.head())->second.visit(pattern, [&](const Fact& fact) {
      ++examined_;
      Bindings bindings;
      found = match(pattern, fact.datum, bindings);
      return !found && examined_ <= limits::examined;
    });
    return found;
  }

  bool finish(Bindings bindings) {
    Answer& answer = answers_.emplace_back();
    answer.bindings = std::move(bindings);
    answer.facts.reserve(chosen_.size());
    for (const Fact* fact : chosen_) answer.facts.push_back(*fact);
    weight_ += weigh(answer);
    const bool enough = enough_ && answers_.size() >= *enough_;
    return !enough && weight_.bytes <= weight_bound_;
  }

  void cut() {
    answers_.resize(*query_.limit);
    weight_ = {};
    for (const Answer& answer : answers_) weight_ += weigh(answer);
  }

  void sort() {
    const auto value = [&](const Answer& answer) -> const Datum& { return *answer.bindings.find(query_.order); };
    std::stable_sort(answers_.begin(), answers_.end(), [&](const Answer& a, const Answer& b) {
      return query_.descending ? compare_values(value(b), value(a)) < 0 : compare_values(value(a), value(b)) < 0;
    });
  }

  const Query& query_;
  const Tables& tables_;
  const Fact* pinned_;
  std::optional<std::size_t> enough_;
  std::vector<const Fact*> chosen_;
  std::vector<Answer> answers_;
  std::size_t examined_ = 0;
  Weight weight_;
  std::size_t weight_bound_ = 0;
};

}  // namespace

bool holds(const Datum& comparison, const Bindings& bindings) {
  const Datum a = substitute(comparison[1], bindings);
  const Datum b = substitute(comparison[2], bindings);
  const std::partial_ordering order = compare_values(a, b);
  const std::string_view name = comparison.head();
  if (name == "=") return order == 0;
  if (name == "/=") return order != 0;
  if (!a.is_number() || !b.is_number()) return false;
  if (name == "<") return order < 0;
  if (name == "<=") return order <= 0;
  if (name == ">") return order > 0;
  return order >= 0;
}

Result<const FactTable*> table_for(const Datum& pattern, const Tables& tables) {
  const auto found = tables.find(pattern.head());
  if (found != tables.end()) {
    const Result<void> fits = check_pattern_shape(found->second.relation(), pattern);
    if (!fits) return fail(fits);
    return &found->second;
  }
  if (pattern.head().empty()) return fail("wrong-shape", "a fact is a list that begins with a symbol", pattern);
  std::vector<std::string> names;
  for (const auto& [name, table] : tables) names.push_back(name);
  const std::string nearest = nearest_name(pattern.head(), names);
  const std::string hint = nearest.empty() ? "" : "; did you mean " + nearest + "?";
  return fail("undeclared-relation", "no relation is called " + std::string(pattern.head()) + hint,
              Datum::symbol(pattern.head()));
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

Result<std::vector<Answer>> evaluate(const Query& query, const Tables& tables, const Fact* pinned) {
  return Search(query, tables, pinned).run();
}

Weight weigh(const Answer& answer) {
  Weight weight;
  weight.bytes = 3;
  weight.elements = 1;
  for (const Fact& fact : answer.facts) weight += weigh(fact);
  return weight;
}

}  // namespace pizarra
