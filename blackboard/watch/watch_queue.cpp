#include "blackboard/watch/watch_queue.hpp"

#include <algorithm>
#include <cassert>

#include "blackboard/limits.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/watch/watches.hpp"
#include "lisp/pattern.hpp"

namespace pizarra {

namespace {

using Kind = Query::Clause::Kind;

const Datum* only_pattern_of(const Query& query) {
  const Datum* only = nullptr;
  if (query.limit || !query.order.empty()) return nullptr;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Kind::absent || (clause.kind == Kind::fact && only != nullptr)) return nullptr;
    if (clause.kind == Kind::fact) only = &clause.form;
  }
  return only;
}

// Whether its arguments are variables, none twice, and nothing is compared.
bool is_fitted_by_all(const Query& query) {
  if (query.clauses.size() != 1) return false;
  std::vector<Datum> variables;
  for (const Datum& argument : query.clauses.front().form.items().subspan(1)) {
    if (!is_variable(argument) || std::ranges::find(variables, argument) != variables.end()) return false;
    if (argument.text() != "?") variables.push_back(argument);
  }
  return true;
}

void add(Delta::Side& side, const Fact& fact) {
  side.facts.push_back(fact);
  ++side.answers;
}

Weight weigh(const Delta& delta) {
  constexpr std::size_t answer_bytes = 3;
  Weight weight;
  for (const Delta::Side* side : {&delta.added, &delta.removed}) {
    for (const Fact& fact : side->facts) weight += pizarra::weigh(fact);
    weight.bytes += answer_bytes * side->answers;
    weight.elements += side->answers;
  }
  return weight;
}

}  // namespace

WatchQueue::WatchQueue(WatchTable& table, const Store& store, Query query, std::shared_ptr<Backlog> backlog)
    : table_(table),
      store_(store),
      query_(std::move(query)),
      only_pattern_(only_pattern_of(query_)),
      fits_all_(only_pattern_ != nullptr && is_fitted_by_all(query_)),
      waiting_(std::move(backlog)) {
  if (only_pattern_ == nullptr) joined_.emplace(query_, store_.tables());
}

WatchQueue::~WatchQueue() {
  if (number_ != 0) table_.forget(*this);
}

// What holds now is the first change, if it fits one message; more than that waits until it is read.
Result<void> WatchQueue::begin() {
  if (only_pattern_ != nullptr) {
    Delta first = next_part();
    if (first.kind == Delta::Kind::all) {
      push(std::move(first));
    } else {
      state_ = State::lagging;
    }
    return {};
  }
  Result<Delta> all = all_answers();
  if (!all) return fail(all);
  push(std::move(*all));
  return {};
}

Result<Delta> WatchQueue::pop_delta() {
  assert(ready());
  if (state_ != State::following) return only_pattern_ != nullptr ? next_part() : all_answers();
  Queued first = std::move(deltas_.front());
  deltas_.pop_front();
  waiting_.remove(first.bytes);
  return std::move(first.delta);
}

Result<Change> WatchQueue::pop() {
  Result<Delta> delta = pop_delta();
  if (!delta) return fail(delta);
  // Nothing can be committed between the parts.
  while (state_ == State::sending) {
    Delta part = next_part();
    delta->added.answers += part.added.answers;
    std::ranges::move(part.added.facts, std::back_inserter(delta->added.facts));
  }
  return change_of(query_, std::move(*delta));
}

void WatchQueue::resynchronise() {
  const bool was_ready = ready();
  empty();
  state_ = State::lagging;
  if (!was_ready && on_ready_) on_ready_();
}

void WatchQueue::empty() {
  deltas_.clear();
  gone_ = {};
  gone_bytes_ = 0;
  waiting_.clear();
}

void WatchQueue::committed(const Commit& commit) {
  if (state_ == State::lagging) return;
  if (state_ == State::sending) return committed_while_sending(commit);
  if (only_pattern_ != nullptr) return committed_by_facts(commit);
  Delta delta;
  delta.revision = commit.revision;
  if (!joined_->follow(commit, delta)) return resynchronise();
  push(std::move(delta));
}

void WatchQueue::committed_by_facts(const Commit& commit) {
  Delta delta;
  delta.revision = commit.revision;
  if (fits_all_) delta.added.facts.reserve(commit.entries.size() / 2);
  if (fits_all_) delta.removed.facts.reserve(commit.entries.size() / 2);
  for (const Commit::Entry& entry : commit.entries) {
    const bool comes = adds(entry);
    if ((comes || removes(entry)) && fits(entry.fact)) add(comes ? delta.added : delta.removed, entry.fact);
  }
  push(std::move(delta));
}

// What comes has a higher id than all that was sent, and is part of what is sent next.
void WatchQueue::committed_while_sending(const Commit& commit) {
  for (const Commit::Entry& entry : commit.entries) {
    if (!removes(entry) || entry.fact.id > sent_up_to_ || !fits(entry.fact)) continue;
    const std::size_t bytes = pizarra::weigh(entry.fact).bytes;
    if (!waiting_.add(bytes)) return resynchronise();
    add(gone_, entry.fact);
    gone_bytes_ += bytes;
  }
  if (gone_bytes_ > limits::part_bytes) resynchronise();
}

bool WatchQueue::fits(const Fact& fact) const {
  if (fact.datum[0] != (*only_pattern_)[0]) return false;
  if (fits_all_) return true;
  Bindings bindings;
  if (!resembles(*only_pattern_, fact.datum) || !match(*only_pattern_, fact.datum, bindings)) return false;
  return std::ranges::all_of(query_.clauses, [&](const Query::Clause& clause) {
    return clause.kind != Kind::compare || holds(clause.form, bindings);
  });
}

Delta WatchQueue::next_part() {
  const bool first = state_ != State::sending;
  if (first) {
    sent_up_to_ = 0;
    empty();
  }
  Delta part;
  part.revision = store_.revision();
  part.removed = std::exchange(gone_, {});
  std::size_t bytes = std::exchange(gone_bytes_, 0);
  waiting_.remove(bytes);
  bool last = true;
  const auto consider = [&](const Fact& fact) {
    if (fits(fact)) {
      const std::size_t more = pizarra::weigh(fact).bytes;
      last = bytes == 0 || bytes + more <= limits::part_bytes;
      if (!last) return false;
      bytes += more;
      add(part.added, fact);
    }
    sent_up_to_ = fact.id;
    return true;
  };
  store_.tables().find(only_pattern_->head())->second.visit(*only_pattern_, consider, sent_up_to_ + 1);
  state_ = last ? State::following : State::sending;
  if (first) part.kind = last ? Delta::Kind::all : Delta::Kind::first_part;
  if (!first) part.kind = last ? Delta::Kind::last_part : Delta::Kind::part;
  return part;
}

Result<Delta> WatchQueue::all_answers() {
  Result<Delta::Side> answers = joined_->all();
  if (!answers) return fail(answers);
  state_ = State::following;
  Delta all;
  all.revision = store_.revision();
  all.kind = Delta::Kind::all;
  all.added = std::move(*answers);
  return all;
}

void WatchQueue::push(Delta delta) {
  if (delta.kind == Delta::Kind::change && delta.added.answers + delta.removed.answers == 0) return;
  const Weight weight = weigh(delta);
  // A change that takes more elements than a frame has is as good as one that takes more bytes.
  const bool fitting = deltas_.size() < limits::pending_changes && check_weight(weight, "a change");
  if (!fitting || !waiting_.add(weight.bytes)) return resynchronise();
  const bool was_ready = ready();
  state_ = State::following;
  deltas_.push_back({std::move(delta), weight.bytes});
  if (!was_ready && on_ready_) on_ready_();
}

}  // namespace pizarra
