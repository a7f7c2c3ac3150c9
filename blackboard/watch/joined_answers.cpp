#include "blackboard/watch/joined_answers.hpp"

#include <algorithm>
#include <set>

#include "blackboard/watch/commit_looks.hpp"
#include "blackboard/watch/join_course.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::watch {

namespace {

using Kind = Query::Clause::Kind;

Weight weigh_answer(const std::vector<Fact>& facts) {
  Weight weight{.bytes = answer_bytes, .elements = 1};
  for (const Fact& fact : facts) weight += weigh(fact);
  return weight;
}

}  // namespace

bool JoinedAnswers::Before::operator()(const Rank& a, const Rank& b) const {
  const std::strong_ordering order = store::compare_values(a.value, b.value);
  if (order != 0) return descending ? order > 0 : order < 0;
  return a.ids < b.ids;
}

JoinedAnswers::JoinedAnswers(const Query& query, const store::Tables& tables)
    : query_(with_own_variables(query)), tables_(tables), standing_(Before{query.descending}) {
  const auto is_absent = [&](std::size_t i) { return query_.clauses[i].kind == Kind::absent; };
  for (std::size_t i = 0; i < query_.clauses.size(); ++i) {
    std::vector<std::size_t> course = course_from(query_, i, tables_);
    positive_courses_.push_back(course);
    std::erase_if(positive_courses_.back(), is_absent);
    // Something else may stand in the way still.
    if (is_absent(i)) course.insert(course.begin(), i);
    courses_.push_back(std::move(course));
  }
}

Result<Delta::Side> JoinedAnswers::all(std::size_t& examined) {
  Result<std::vector<Answer>> answers = store::evaluate(query_, tables_, examined);
  if (!answers) return fail(answers);
  standing_with_.clear();
  standing_.clear();
  weight_ = {};
  Delta::Side side;
  for (Answer& answer : *answers) {
    std::ranges::copy(answer.facts, std::back_inserter(side.facts));
    add(std::move(answer), nullptr);
  }
  side.answers = standing_.size();
  return side;
}

Result<void> JoinedAnswers::follow(const store::Commit& commit, Delta& delta, std::size_t& examined) {
  Changes changes{Answers(standing_.key_comp()), Answers(standing_.key_comp())};
  const bool was_full = query_.limit && standing_.size() >= *query_.limit;
  for (const store::Commit::Entry& entry : commit.entries) {
    if (store::removes(entry)) remove_with(entry.fact.id, changes, examined);
  }
  Result<void> done = check_allowed(examined);
  if (done) done = find_blocked(commit, changes, examined);
  const bool anew = was_full && !changes.removed.empty();
  if (done) done = anew ? answer_anew(changes, examined) : find_new(commit, changes, examined);
  if (!done) return done;
  cut(changes);
  const auto move_to = [](Delta::Side& side, Answers& answers) {
    side.answers = answers.size();
    for (auto& [rank, answer] : answers) std::ranges::move(answer.facts, std::back_inserter(side.facts));
  };
  move_to(delta.added, changes.added);
  move_to(delta.removed, changes.removed);
  return check_weight(weight_, "the answer");
}

JoinedAnswers::Rank JoinedAnswers::rank_of(const Answer& answer) const {
  Rank rank;
  if (!query_.order.empty()) rank.value = *answer.bindings.find(query_.order);
  for (const Fact& fact : answer.facts) rank.ids.push_back(fact.id);
  return rank;
}

void JoinedAnswers::add(Answer answer, Changes* changes) {
  const auto [place, fresh] = standing_.try_emplace(rank_of(answer), Standing{next_serial_, {}});
  if (!fresh) return;
  ++next_serial_;
  place->second.facts = std::move(answer.facts);
  for (const Fact& fact : place->second.facts) standing_with_[{fact.id, place->second.serial}] = place;
  weight_ += weigh_answer(place->second.facts);
  if (changes != nullptr) changes->added.insert(*place);
}

// An answer that came by the same commit was never sent, and goes without a word.
void JoinedAnswers::remove(Answers::iterator answer, Changes& changes) {
  for (const Fact& fact : answer->second.facts) standing_with_.erase({fact.id, answer->second.serial});
  const Weight weight = weigh_answer(answer->second.facts);
  weight_.bytes -= weight.bytes;
  weight_.elements -= weight.elements;
  auto node = standing_.extract(answer);
  if (changes.added.erase(node.key()) == 0) changes.removed.insert(std::move(node));
}

void JoinedAnswers::remove_with(FactId fact, Changes& changes, std::size_t& examined) {
  ++examined;
  for (auto next = standing_with_.lower_bound({fact, 0}); next != standing_with_.end() && next->first.first == fact;
       next = standing_with_.lower_bound({fact, 0})) {
    if (examined > limits::examined) return;
    examined += CommitLooks::looks_an_answer;
    remove(next->second, changes);
  }
}

void JoinedAnswers::cut(Changes& changes) {
  while (query_.limit && standing_.size() > *query_.limit) remove(std::prev(standing_.end()), changes);
}

// Nothing where the clause is not about the fact.
std::optional<store::SearchStart> JoinedAnswers::start_from(const Fact& fact, std::size_t clause) const {
  const auto& [kind, form] = query_.clauses[clause];
  Bindings bindings;
  if (!resembles(form, fact.datum) || !match(form, fact.datum, bindings)) return std::nullopt;
  if (kind == Kind::fact) return store::SearchStart{std::move(bindings), clause, &fact};
  return store::SearchStart{shared_bindings(query_, bindings), clause, nullptr};
}

Result<void> JoinedAnswers::check_allowed(std::size_t examined) const {
  if (examined <= limits::examined) return {};
  return check_examined(examined, query_to_datum(query_));
}

Result<std::vector<Answer>> JoinedAnswers::search_from(store::SearchStart start, const std::vector<std::size_t>& course,
                                                       std::size_t& examined) const {
  examined += CommitLooks::looks_a_search;
  Result<std::vector<Answer>> found = store::evaluate_from(std::move(start), course, query_, tables_, examined);
  if (found) examined += CommitLooks::looks_an_answer * found->size();
  return found;
}

Result<void> JoinedAnswers::find_blocked(const store::Commit& commit, Changes& changes, std::size_t& examined) {
  for (std::size_t clause = 0; clause < query_.clauses.size(); ++clause) {
    if (query_.clauses[clause].kind != Kind::absent) continue;
    for (const store::Commit::Entry& entry : commit.entries) {
      if (!store::adds(entry) || standing_.empty()) continue;
      const Result<void> allowed = check_allowed(++examined);
      if (!allowed) return allowed;
      std::optional<store::SearchStart> start = start_from(entry.fact, clause);
      if (!start) continue;
      const Result<std::vector<Answer>> blocked = search_from(std::move(*start), positive_courses_[clause], examined);
      if (!blocked) return fail(blocked);
      for (const Answer& answer : *blocked) {
        const auto found = standing_.find(rank_of(answer));
        if (found != standing_.end()) remove(found, changes);
      }
    }
  }
  return {};
}

Result<void> JoinedAnswers::find_new(const store::Commit& commit, Changes& changes, std::size_t& examined) {
  for (std::size_t clause = 0; clause < query_.clauses.size(); ++clause) {
    const Kind kind = query_.clauses[clause].kind;
    if (kind == Kind::compare) continue;
    for (const store::Commit::Entry& entry : commit.entries) {
      if (kind == Kind::fact ? !store::adds(entry) : !store::removes(entry)) continue;
      const Result<void> allowed = check_allowed(++examined);
      if (!allowed) return allowed;
      std::optional<store::SearchStart> start = start_from(entry.fact, clause);
      if (!start) continue;
      Result<std::vector<Answer>> found = search_from(std::move(*start), courses_[clause], examined);
      if (!found) return fail(found);
      for (Answer& answer : *found) add(std::move(answer), &changes);
    }
  }
  return {};
}

Result<void> JoinedAnswers::answer_anew(Changes& changes, std::size_t& examined) {
  Result<std::vector<Answer>> answers = store::evaluate(query_, tables_, examined);
  if (!answers) return fail(answers);
  std::set<Ids> now;
  for (Answer& answer : *answers) {
    now.insert(rank_of(answer).ids);
    add(std::move(answer), &changes);
  }
  for (auto answer = standing_.begin(); answer != standing_.end();) {
    const auto next = std::next(answer);
    if (!now.contains(answer->first.ids)) remove(answer, changes);
    answer = next;
  }
  return {};
}

}  // namespace pizarra::watch
