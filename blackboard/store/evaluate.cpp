#include "blackboard/store/evaluate.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "blackboard/store/looking.hpp"
#include "blackboard/store/narrowing.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::store {

namespace {

// An answer that is to be ordered and cut to a limit may pass through this many frames' worth of others.
constexpr std::size_t frames_to_sort = 64;

std::unexpected<Failure> too_many(const Query& query) {
  return fail("too-large", "the answers are more than fit one message", query_to_datum(query));
}

bool is_known(const Datum& form, const std::vector<Datum>& known) {
  if (is_variable(form)) return std::ranges::find(known, form) != known.end();
  return std::ranges::all_of(form.items(), [&](const Datum& item) { return is_known(item, known); });
}

void learn(const Datum& pattern, std::vector<Datum>& known) {
  if (is_variable(pattern)) known.push_back(pattern);
  for (const Datum& item : pattern.items()) learn(item, known);
}

// The patterns as written, each comparison as soon as it can be made.
std::vector<std::size_t> course_of(const Query& query) {
  std::vector<std::size_t> course;
  std::vector<std::size_t> comparisons;
  for (std::size_t i = 0; i < query.clauses.size(); ++i) {
    if (query.clauses[i].kind == Query::Clause::Kind::compare) comparisons.push_back(i);
  }
  std::vector<Datum> known;
  const auto compare = [&] {
    std::erase_if(comparisons, [&](std::size_t i) {
      if (!is_known(query.clauses[i].form, known)) return false;
      course.push_back(i);
      return true;
    });
  };
  compare();
  for (std::size_t i = 0; i < query.clauses.size(); ++i) {
    if (query.clauses[i].kind == Query::Clause::Kind::compare) continue;
    course.push_back(i);
    if (query.clauses[i].kind == Query::Clause::Kind::absent) continue;
    learn(query.clauses[i].form, known);
    compare();
  }
  return course;
}

struct ByValue {
  bool descending;
  bool operator()(const Datum& a, const Datum& b) const {
    return descending ? compare_values(b, a) < 0 : compare_values(a, b) < 0;
  }
};

class Search {
 public:
  Search(const Query& query, const Tables& tables, std::span<const std::size_t> course, std::size_t& examined)
      : query_(query),
        tables_(tables),
        course_(course),
        chosen_(query.clauses.size()),
        sorted_(ByValue{query.descending}),
        looking_(examined) {}

  // The query's answers, in its order and up to its limit.
  Result<std::vector<Answer>> whole() {
    sorts_ = !query_.order.empty();
    if (!sorts_) enough_ = query_.limit;
    if (sorts_ && query_.limit) weight_bound_ *= frames_to_sort;
    if (sorts_ && query_.limit) order_first_pattern();
    if (query_.limit != 0U) extend(0, {});
    const Result<void> done = check_bounds();
    if (!done) return fail(done);
    for (auto& [value, answer] : sorted_) answers_.push_back(std::move(answer));
    if (!check_weight(weight_, "the answer")) return too_many(query_);
    return std::move(answers_);
  }

  Result<std::vector<Answer>> from(SearchStart start) {
    if (query_.limit) weight_bound_ *= frames_to_sort;
    chosen_[start.clause] = start.fact;
    extend(0, std::move(start.bindings));
    const Result<void> done = check_bounds();
    if (!done) return fail(done);
    return std::move(answers_);
  }

 private:
  void order_first_pattern() {
    const auto is_fact = [&](std::size_t i) { return query_.clauses[i].kind == Query::Clause::Kind::fact; };
    const auto first = std::ranges::find_if(course_, is_fact);
    const auto argument = argument_of(Datum::symbol(query_.order), query_.clauses[*first].form);
    if (!argument) return;
    ordered_step_ = static_cast<std::size_t>(first - course_.begin());
    order_ = {*argument, query_.descending};
    enough_ = query_.limit;
    sorts_ = false;
  }

  Result<void> check_bounds() const {
    if (!looking_.is_allowed()) return check_looking(looking_.examined(), query_to_datum(query_));
    if (weight_.bytes > weight_bound_) return too_many(query_);
    return {};
  }

  // Whether the search should go on.
  bool extend(std::size_t step, Bindings bindings) {
    if (step == course_.size()) return finish(std::move(bindings));
    const Query::Clause& next = query_.clauses[course_[step]];
    switch (next.kind) {
      case Query::Clause::Kind::compare:
        if (!look_at_comparison()) return false;
        return !holds(next.form, bindings) || extend(step + 1, std::move(bindings));
      case Query::Clause::Kind::absent:
        return exists(substitute(next.form, bindings)) || extend(step + 1, std::move(bindings));
      case Query::Clause::Kind::fact:
        return extend_by_fact(step, bindings);
    }
    return false;
  }

  bool look() {
    ++looks_;
    return looking_.at_one_more();
  }
  // The first comparison of each fact is free: it costs less than the fact did.
  bool look_at_comparison() { return ++comparisons_ <= looks_ || look(); }

  bool extend_by_fact(std::size_t step, const Bindings& bindings) {
    const std::size_t clause = course_[step];
    const Datum& form = query_.clauses[clause].form;
    bool go_on = true;
    const std::size_t before = looks_;
    const auto consider = [&](const Fact& fact) {
      if (!look()) return go_on = false;
      Bindings both = bindings;
      if (!match(form, fact.datum, both)) return true;
      chosen_[clause] = &fact;
      go_on = extend(step + 1, std::move(both));
      return go_on;
    };
    const FactTable& table = tables_.find(form.head())->second;
    const Datum pattern = bindings.all().empty() ? form : substitute(form, bindings);
    const std::vector<ValueRange> ranges = ranges_for(pattern, step, bindings);
    const bool ordered = ordered_step_ == step && table.visit_ordered(pattern, order_, ranges, consider);
    if (ordered_step_ == step && !ordered) collect_all();
    if (!ordered) table.visit_within(pattern, ranges, consider);
    chosen_[clause] = nullptr;
    return go_on && (looks_ > before || look());
  }

  std::vector<ValueRange> ranges_for(const Datum& pattern, std::size_t step, const Bindings& bindings) const {
    std::vector<ValueRange> ranges;
    for (const std::size_t later : course_.subspan(step + 1)) {
      const auto& [kind, form] = query_.clauses[later];
      if (kind == Query::Clause::Kind::compare) narrow(ranges, pattern, substitute(form, bindings));
    }
    return ranges;
  }

  // Begins anew, to sort what is found.
  void collect_all() {
    ordered_step_.reset();
    enough_.reset();
    sorts_ = true;
    answers_.clear();
    weight_ = {};
  }

  bool exists(const Datum& pattern) {
    bool found = false;
    const std::size_t before = looks_;
    tables_.find(pattern.head())->second.visit(pattern, [&](const Fact& fact) {
      const bool is_allowed = look();
      Bindings bindings;
      found = match(pattern, fact.datum, bindings);
      return !found && is_allowed;
    });
    // To look for what is not there takes as long.
    if (looks_ == before) look();
    return found;
  }

  bool finish(Bindings bindings) {
    if (sorts_) return sort_in(std::move(bindings));
    answers_.push_back(answer_of(std::move(bindings)));
    weight_ += weigh(answers_.back());
    const bool enough = enough_ && answers_.size() >= *enough_;
    return !enough && weight_.bytes <= weight_bound_;
  }

  // Among those before it, so that what is compared counts before the next one is looked for.
  bool sort_in(Bindings bindings) {
    const Datum value = *bindings.find(query_.order);
    const bool full = query_.limit && sorted_.size() >= *query_.limit;
    if (full && !sorted_.key_comp()(value, std::prev(sorted_.end())->first)) return true;
    const auto place = sorted_.emplace(value, answer_of(std::move(bindings)));
    weight_ += weigh(place->second);
    if (full) drop_last();
    return weight_.bytes <= weight_bound_;
  }

  void drop_last() {
    const auto last = std::prev(sorted_.end());
    const Weight less = weigh(last->second);
    weight_.bytes -= less.bytes;
    weight_.elements -= less.elements;
    sorted_.erase(last);
  }

  Answer answer_of(Bindings bindings) const {
    Answer answer{.bindings = std::move(bindings), .facts = {}};
    for (const Fact* fact : chosen_) {
      if (fact != nullptr) answer.facts.push_back(*fact);
    }
    return answer;
  }

  const Query& query_;
  const Tables& tables_;
  const std::span<const std::size_t> course_;  // the clauses, in the order they are satisfied in
  bool sorts_ = false;                         // by values, and keeps no more than the limit
  std::optional<std::size_t> enough_;
  std::optional<std::size_t> ordered_step_;  // that finds the answers in their order
  FactTable::Order order_{};
  std::vector<const Fact*> chosen_;  // by each clause
  std::vector<Answer> answers_;
  std::multimap<Datum, Answer, ByValue> sorted_;
  Looking looking_;
  std::size_t looks_ = 0;
  std::size_t comparisons_ = 0;
  Weight weight_;
  std::size_t weight_bound_ = limits::bytes;
};

// The answer to a pattern that binds its relation's key: one fact at most, found without a search.
Result<std::vector<Answer>> find_by_key(const Query& query, const FactTable& table) {
  const Datum& pattern = query.clauses.front().form;
  std::vector<Answer> answers;
  const StandingFact* only = table.find_key_of(pattern);
  Bindings bindings;
  if (only == nullptr || query.limit == 0U || !match(pattern, only->fact.datum, bindings)) return answers;
  Answer& answer = answers.emplace_back();
  answer.bindings = std::move(bindings);
  answer.facts.push_back(only->fact);
  if (!check_weight(weigh(answer), "the answer")) return too_many(query);
  return answers;
}

}  // namespace

bool holds(const Datum& comparison, const Bindings& bindings) {
  const Datum a = substitute(comparison[1], bindings);
  const Datum b = substitute(comparison[2], bindings);
  const std::strong_ordering order = compare_values(a, b);
  const std::string_view name = comparison.head();
  if (name == "=") return order == 0;
  if (name == "/=") return order != 0;
  if (!a.is_number() || !b.is_number()) return false;
  if (name == "<") return order < 0;
  if (name == "<=") return order <= 0;
  if (name == ">") return order > 0;
  return order >= 0;
}

Result<std::vector<Answer>> evaluate(const Query& query, const Tables& tables) {
  std::size_t examined = 0;
  return evaluate(query, tables, examined);
}

Result<std::vector<Answer>> evaluate(const Query& query, const Tables& tables, std::size_t& examined) {
  const Query::Clause& first = query.clauses.front();
  if (query.clauses.size() == 1 && first.kind == Query::Clause::Kind::fact) {
    const FactTable& table = tables.find(first.form.head())->second;
    if (table.key_is_ground(first.form)) return find_by_key(query, table);
  }
  const std::vector<std::size_t> course = course_of(query);
  return Search(query, tables, course, examined).whole();
}

Result<std::vector<Answer>> evaluate_from(SearchStart start, std::span<const std::size_t> course, const Query& query,
                                          const Tables& tables, std::size_t& examined) {
  return Search(query, tables, course, examined).from(std::move(start));
}

Weight weigh(const Answer& answer) {
  Weight weight;
  weight.bytes = 3;
  weight.elements = 1;
  for (const Fact& fact : answer.facts) weight += weigh(fact);
  return weight;
}

}  // namespace pizarra::store
