#include "blackboard/watches.hpp"

#include <algorithm>
#include <cassert>

#include "blackboard/evaluate.hpp"
#include "blackboard/limits.hpp"
#include "lisp/pattern.hpp"

namespace pizarra {

namespace {

bool has_one_fact(const Query& query) {
  std::size_t facts = 0;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::absent) return false;
    if (clause.kind == Query::Clause::Kind::fact) ++facts;
  }
  return facts == 1 && !query.limit;
}

std::vector<FactId> key_of_answer(const Answer& answer) {
  std::vector<FactId> key;
  for (const Fact& fact : answer.facts) key.push_back(fact.id);
  return key;
}

std::size_t bytes_of(const Change& change) {
  std::size_t bytes = 0;
  for (const Answer& answer : change.added) bytes += weigh(answer).bytes;
  for (const Answer& answer : change.removed) bytes += weigh(answer).bytes;
  return bytes;
}

// A change that takes more elements than a frame has is as good as one that takes more bytes.
bool fits_frame(const Change& change) {
  Weight weight;
  for (const Answer& answer : change.added) weight += weigh(answer);
  for (const Answer& answer : change.removed) weight += weigh(answer);
  return check_weight(weight, "a change").has_value();
}

}  // namespace

WatchQueue::WatchQueue(WatchTable& table, Query query, std::function<void()> on_ready)
    : table_(table), query_(std::move(query)), by_facts_(has_one_fact(query_)), on_ready_(std::move(on_ready)) {}

WatchQueue::~WatchQueue() {
  if (number_ == 0) return;
  table_.watches_.erase(number_);
  for (const WatchTable::Interest& interest : table_.interests_of(query_)) {
    const auto found = table_.interested_.find(interest);
    if (found == table_.interested_.end()) continue;
    found->second.erase(number_);
    if (found->second.empty()) table_.interested_.erase(found);
  }
}

Result<std::vector<Answer>> WatchQueue::answers_now() {
  Result<std::vector<Answer>> answers = evaluate(query_, table_.store_.tables());
  if (!answers || by_facts_) return answers;
  standing_.clear();
  for (const Answer& answer : *answers) standing_.emplace(key_of_answer(answer), answer);
  return answers;
}

Result<void> WatchQueue::begin() {
  Result<std::vector<Answer>> answers = answers_now();
  if (!answers) return fail(answers);
  push({table_.store_.revision(), true, std::move(*answers), {}});
  return {};
}

Result<Change> WatchQueue::pop() {
  assert(ready());
  if (lagging_) {
    Result<std::vector<Answer>> answers = answers_now();
    if (!answers) return fail(answers);
    lagging_ = false;
    return Change{table_.store_.revision(), true, std::move(*answers), {}};
  }
  Queued first = std::move(changes_.front());
  changes_.pop_front();
  queued_bytes_ -= first.bytes;
  return std::move(first.change);
}

void WatchQueue::resynchronise() {
  const bool was_ready = ready();
  changes_.clear();
  queued_bytes_ = 0;
  lagging_ = true;
  if (!was_ready && on_ready_) on_ready_();
}

void WatchQueue::committed(const Commit& commit) {
  if (lagging_) return;
  if (by_facts_) return push(difference_by_facts(commit));
  Result<Change> change = difference_by_answers(commit);
  if (!change) return resynchronise();
  push(std::move(*change));
}

Change WatchQueue::difference_by_facts(const Commit& commit) const {
  Change change;
  change.revision = commit.revision;
  for (const Commit::Entry& entry : commit.entries) {
    if (!adds(entry) && !removes(entry)) continue;
    Result<std::vector<Answer>> answers = evaluate(query_, table_.store_.tables(), &entry.fact);
    std::vector<Answer>& side = adds(entry) ? change.added : change.removed;
    if (answers) side.insert(side.end(), answers->begin(), answers->end());
  }
  return change;
}

Result<Change> WatchQueue::difference_by_answers(const Commit& commit) {
  std::map<AnswerKey, Answer> before;
  before.swap(standing_);
  Result<std::vector<Answer>> answers = answers_now();
  if (!answers) return fail(answers);
  Change change;
  change.revision = commit.revision;
  for (Answer& answer : *answers) {
    if (!before.contains(key_of_answer(answer))) change.added.push_back(std::move(answer));
  }
  for (auto& [key, answer] : before) {
    if (!standing_.contains(key)) change.removed.push_back(std::move(answer));
  }
  return change;
}

void WatchQueue::push(Change change) {
  if (change.added.empty() && change.removed.empty() && !change.resynchronised) return;
  const std::size_t bytes = bytes_of(change);
  const bool room = changes_.size() < limits::pending_changes && queued_bytes_ + bytes <= limits::frame_bytes;
  if (!room || !fits_frame(change)) return resynchronise();
  const bool was_ready = ready();
  changes_.push_back({std::move(change), bytes});
  queued_bytes_ += bytes;
  if (!was_ready && on_ready_) on_ready_();
}

WatchTable::~WatchTable() { assert(watches_.empty()); }

Result<std::unique_ptr<WatchQueue>> WatchTable::add(const Query& query, std::function<void()> on_ready) {
  if (watches_.size() >= limits::watches) return fail("too-large", "the board has too many watches");
  const Result<void> checked = check_query_on(query, store_.tables());
  if (!checked) return fail(checked);
  auto queue = std::make_unique<WatchQueue>(*this, query, nullptr);
  const Result<void> begun = queue->begin();
  if (!begun) return fail(begun);
  queue->on_ready_ = std::move(on_ready);
  queue->number_ = next_number_++;
  watches_.emplace(queue->number_, queue.get());
  for (Interest& interest : interests_of(query)) interested_[std::move(interest)].insert(queue->number_);
  return queue;
}

void WatchTable::committed(const Commit& commit) {
  std::map<std::uint64_t, WatchQueue*> touched;
  for (const Commit::Entry& entry : commit.entries) {
    if (!adds(entry) && !removes(entry)) continue;
    const Relation& relation = store_.tables().find(entry.fact.datum.head())->second.relation();
    collect({relation.name, {}}, touched);
    collect({relation.name, key_of(relation, entry.fact.datum)}, touched);
  }
  for (const auto& [number, watch] : touched) watch->committed(commit);
}

std::vector<WatchTable::Interest> WatchTable::interests_of(const Query& query) const {
  std::vector<Interest> interests;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    const Relation& relation = store_.tables().find(clause.form.head())->second.relation();
    const Datum key = key_of(relation, clause.form);
    interests.emplace_back(relation.name, is_ground(key) ? key : Datum());
  }
  return interests;
}

void WatchTable::collect(const Interest& interest, std::map<std::uint64_t, WatchQueue*>& into) const {
  const auto found = interested_.find(interest);
  if (found == interested_.end()) return;
  for (const std::uint64_t number : found->second) into.emplace(number, watches_.at(number));
}

}  // namespace pizarra
