#include "blackboard/watch/watch_queue.hpp"

#include <algorithm>
#include <cassert>

#include "blackboard/limits.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/watch/watch_table.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::watch {

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
  const Datum& pattern = query.clauses.front().form;
  return FlatPattern::of(pattern) && std::ranges::all_of(pattern.items().subspan(1), is_variable);
}

std::size_t looks_to_fit(const Query& query) {
  const auto is_comparison = [](const Query::Clause& clause) { return clause.kind == Kind::compare; };
  const auto comparisons = static_cast<std::size_t>(std::ranges::count_if(query.clauses, is_comparison));
  return 1 + comparisons * CommitLooks::looks_a_comparison;
}

void add(Delta::Side& side, const Fact& fact) {
  side.facts.push_back(fact);
  ++side.answers;
}

Weight weigh_as_answer(const Fact& fact) {
  Weight weight = pizarra::weigh(fact);
  weight.bytes += answer_bytes;
  ++weight.elements;
  return weight;
}

Weight weigh(const Delta& delta) {
  Weight weight;
  for (const Delta::Side* side : {&delta.added, &delta.removed}) {
    for (const Fact& fact : side->facts) weight += pizarra::weigh(fact);
    weight.bytes += answer_bytes * side->answers;
    weight.elements += side->answers;
  }
  return weight;
}

}  // namespace

WatchQueue::WatchQueue(WatchTable& table, const store::Store& store, Query query, std::shared_ptr<Backlog> backlog)
    : table_(table),
      store_(store),
      query_(std::move(query)),
      only_pattern_(only_pattern_of(query_)),
      fits_all_(only_pattern_ != nullptr && is_fitted_by_all(query_)),
      looks_to_fit_(looks_to_fit(query_)),
      waiting_(std::move(backlog)) {
  if (only_pattern_ == nullptr) joined_.emplace(query_, store_.tables());
}

WatchQueue::~WatchQueue() {
  if (number_ != 0) table_.forget(*this);
}

// The first change holds all current answers, if they fit one message and are found at once; more than that waits until
// it is read.
Result<void> WatchQueue::begin(std::size_t& examined) {
  if (examined >= limits::examined_a_turn) return {};
  if (only_pattern_ != nullptr) {
    std::optional<Delta> first = next_part(examined);
    if (first && first->kind == Delta::Kind::all) {
      push(std::move(*first));
    } else {
      state_ = State::lagging;
    }
    return {};
  }
  Result<Delta> all = all_answers(examined);
  if (!all) return fail(all);
  push(std::move(*all));
  return {};
}

Result<std::optional<Delta>> WatchQueue::pop_delta(std::size_t& examined) {
  assert(ready());
  if (state_ == State::following) return pop_queued();
  if (store_.index_maker().is_awaited(awaited_)) store::Indexing::await(awaited_);
  if (store::Indexing::is_awaiting()) return std::nullopt;
  if (only_pattern_ != nullptr) return next_part(examined);
  Result<Delta> all = all_answers(examined);
  if (store::Indexing::is_awaiting()) return std::nullopt;
  return all;
}

Result<Change> WatchQueue::pop() {
  assert(ready());
  if (!answering_) answering_ = std::make_unique<const Answering>(query_);
  if (state_ == State::following) return answering_->change(pop_queued());
  if (only_pattern_ != nullptr) return answering_->change(all_parts());
  std::size_t examined = 0;
  Result<Delta> all = all_answers(examined);
  if (!all) return fail(all);
  return answering_->change(std::move(*all));
}

Delta WatchQueue::pop_queued() {
  Queued first = std::move(deltas_.front());
  deltas_.pop_front();
  waiting_.remove(first.bytes);
  return std::move(first.delta);
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

// One that may not look at enough, or needs an index first, begins anew in a turn of its own.
void WatchQueue::committed(const store::Commit& commit, CommitLooks& looks) {
  if (state_ == State::lagging) return;
  const std::size_t before = looks.before(waiting_.backlog());
  std::size_t examined = before + CommitLooks::looks_a_watch;
  const bool goes_on = examined <= limits::examined && follow(commit, examined);
  looks.add(waiting_.backlog(), examined - before);
  examined_ += examined - before;
  if (!goes_on) resynchronise();
}

bool WatchQueue::follow(const store::Commit& commit, std::size_t& examined) {
  if (state_ == State::sending) return follow_while_sending(commit, examined);
  return only_pattern_ != nullptr ? follow_facts(commit, examined) : follow_joins(commit, examined);
}

bool WatchQueue::follow_joins(const store::Commit& commit, std::size_t& examined) {
  Delta delta;
  delta.revision = commit.revision;
  // The committer does not pay for the indexes that watches need.
  const store::Indexing indexing(store_.index_maker().may(), &store_.index_maker());
  const Result<void> followed = joined_->follow(commit, delta, examined);
  awaited_ = indexing.awaited();
  if (!followed) return false;
  const Weight weight = weigh(delta);
  examined += weight.bytes / CommitLooks::bytes_a_look;
  return push(std::move(delta), weight);
}

bool WatchQueue::follow_facts(const store::Commit& commit, std::size_t& examined) {
  store::Looking looking(examined);
  if (!looking.at_more(commit.entries.size() * looks_to_fit_)) return false;
  Delta delta;
  delta.revision = commit.revision;
  if (fits_all_) delta.added.facts.reserve(commit.entries.size() / 2);
  if (fits_all_) delta.removed.facts.reserve(commit.entries.size() / 2);
  Weight weight;
  for (const store::Commit::Entry& entry : commit.entries) {
    const bool comes = store::adds(entry);
    if (!(comes || store::removes(entry)) || !fits(entry.fact)) continue;
    const Weight more = weigh_as_answer(entry.fact);
    if (!looking.at_more(1 + more.bytes / CommitLooks::bytes_a_look)) return false;
    weight += more;
    add(comes ? delta.added : delta.removed, entry.fact);
  }
  return push(std::move(delta), weight);
}

// A new fact has a higher id than all that were looked at, and is part of the next message.
bool WatchQueue::follow_while_sending(const store::Commit& commit, std::size_t& examined) {
  if (nothing_sent_) return true;
  store::Looking looking(examined);
  if (!looking.at_more(commit.entries.size() * looks_to_fit_)) return false;
  for (const store::Commit::Entry& entry : commit.entries) {
    if (!store::removes(entry) || entry.fact.id > looked_up_to_ || !fits(entry.fact)) continue;
    const std::size_t bytes = pizarra::weigh(entry.fact).bytes;
    if (!looking.at_more(1 + bytes / CommitLooks::bytes_a_look) || !waiting_.add(bytes)) return false;
    add(gone_, entry.fact);
    gone_bytes_ += bytes;
  }
  return gone_bytes_ <= limits::part_bytes;
}

bool WatchQueue::fits(const Fact& fact) const {
  if (fact.datum[0] != (*only_pattern_)[0]) return false;
  if (fits_all_) return true;
  Bindings bindings;
  if (!resembles(*only_pattern_, fact.datum) || !match(*only_pattern_, fact.datum, bindings)) return false;
  return std::ranges::all_of(query_.clauses, [&](const Query::Clause& clause) {
    return clause.kind != Kind::compare || store::holds(clause.form, bindings);
  });
}

std::optional<Delta> WatchQueue::next_part(std::size_t& examined) {
  if (state_ == State::lagging) begin_sending();
  Delta part;
  part.revision = store_.revision();
  part.removed = std::exchange(gone_, {});
  std::size_t bytes = std::exchange(gone_bytes_, 0);
  waiting_.remove(bytes);
  store::Looking looking(examined, limits::examined_a_turn);
  bool last = true;
  const auto consider = [&](const Fact& fact) {
    last = looking.at_one_more();
    if (last && fits(fact)) {
      const std::size_t more = pizarra::weigh(fact).bytes;
      last = bytes == 0 || bytes + more <= limits::part_bytes;
      bytes += more;
      if (last) add(part.added, fact);
    }
    if (last) looked_up_to_ = fact.id;
    return last;
  };
  store_.tables().find(only_pattern_->head())->second.visit(*only_pattern_, consider, looked_up_to_ + 1);
  last = last && !store::Indexing::is_awaiting();
  if (!last && part.added.facts.empty() && part.removed.facts.empty()) return std::nullopt;
  if (last) state_ = State::following;
  const bool first = std::exchange(nothing_sent_, false);
  if (first) part.kind = last ? Delta::Kind::all : Delta::Kind::first_part;
  if (!first) part.kind = last ? Delta::Kind::last_part : Delta::Kind::part;
  return part;
}

void WatchQueue::begin_sending() {
  empty();
  state_ = State::sending;
  looked_up_to_ = 0;
  nothing_sent_ = true;
}

// Nothing can be committed between the parts.
Delta WatchQueue::all_parts() {
  Delta all;
  while (state_ != State::following) {
    std::size_t examined = 0;
    std::optional<Delta> part = next_part(examined);
    if (!part) continue;
    all.added.answers += part->added.answers;
    std::ranges::move(part->added.facts, std::back_inserter(all.added.facts));
  }
  all.revision = store_.revision();
  all.kind = Delta::Kind::all;
  return all;
}

Result<Delta> WatchQueue::all_answers(std::size_t& examined) {
  std::size_t own = 0;
  Result<Delta::Side> answers = joined_->all(own);
  examined += own;
  if (!answers) return fail(answers);
  state_ = State::following;
  Delta all;
  all.revision = store_.revision();
  all.kind = Delta::Kind::all;
  all.added = std::move(*answers);
  return all;
}

void WatchQueue::push(Delta delta) {
  const Weight weight = weigh(delta);
  if (!push(std::move(delta), weight)) resynchronise();
}

bool WatchQueue::push(Delta delta, const Weight& weight) {
  if (delta.kind == Delta::Kind::change && delta.added.answers + delta.removed.answers == 0) return true;
  // A change that takes more elements than a frame has is as good as one that takes more bytes.
  const bool fitting = deltas_.size() < limits::pending_changes && check_weight(weight, "a change");
  if (!fitting || !waiting_.add(weight.bytes)) return false;
  const bool was_ready = ready();
  state_ = State::following;
  deltas_.push_back({std::move(delta), weight.bytes});
  if (!was_ready && on_ready_) on_ready_();
  return true;
}

}  // namespace pizarra::watch
