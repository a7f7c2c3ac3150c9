#include "blackboard/client/replicas.hpp"

#include <algorithm>

#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/query_tables.hpp"

namespace pizarra::client {

namespace {

Query everything_in(const Relation& relation) {
  std::vector<Datum> pattern = {Datum::symbol(relation.name)};
  pattern.resize(relation.arguments.size() + 1, "?"_sym);
  return query_for(Datum::list(std::move(pattern)));
}

}  // namespace

Replicas::Replicas(RemoteBoard& board, Executor& executor) : board_(board), executor_(executor) {}
Replicas::~Replicas() = default;

Replica* Replicas::find(const std::string& relation) const {
  const auto found = replicas_.find(relation);
  return found == replicas_.end() ? nullptr : found->second.get();
}

Replica& Replicas::add(const Relation& relation) {
  tables_.try_emplace(relation.name, relation);
  auto& replica = replicas_[relation.name];
  replica = std::make_unique<Replica>(*this, relation);
  return *replica;
}

void Replicas::remove(const std::string& relation) {
  replicas_.erase(relation);
  tables_.erase(relation);
}

const Replica* Replicas::concerned(const Query& query) const {
  const Replica* only = nullptr;
  if (query.at) return nullptr;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare) continue;
    const auto found = replicas_.find(clause.form.head());
    if (found == replicas_.end() || (only != nullptr && found->second.get() != only)) return nullptr;
    only = found->second.get();
  }
  return only;
}

std::optional<Result<Answers>> Replicas::ask(const Query& query) const {
  const Replica* replica = concerned(query);
  if (replica == nullptr || !replica->whole() || unsure_) return std::nullopt;
  const Revision revision = std::max(replica->revision(), caught_up_);
  if (revision < done_) return std::nullopt;
  const Result<void> checked = store::check_query_on(query, tables_);
  if (!checked) return fail(checked);
  Result<std::vector<Answer>> answers = store::evaluate(query, tables_);
  if (!answers) return fail(answers);
  return Answers{revision, std::move(*answers)};
}

void Replicas::answered_at(Revision revision, bool sent) {
  unsure_ = false;
  done_ = std::max(done_, revision);
  if (sent) caught_up_ = std::max(caught_up_, revision);
}

void Replicas::begin_again() {
  done_ = 0;
  caught_up_ = 0;
  unsure_ = false;
}

Replica::Replica(Replicas& replicas, const Relation& relation)
    : RemoteChanges(replicas.board_, everything_in(relation), true),
      replicas_(replicas),
      relation_(relation),
      known_(replicas.executor_) {}

void Replica::end(Failure failure) {
  ended_ = std::move(failure);
  whole_ = false;
  known_.set();
}

void Replica::come(std::uint64_t sequence, Delta delta) {
  const bool part = delta.kind == Delta::Kind::first_part || delta.kind == Delta::Kind::part;
  const Result<void> taken = take_in(std::move(delta));
  if (!taken) return end(taken.error());
  read_up_to(sequence, part);
}

Result<void> Replica::take_in(Delta delta) {
  if (delta.kind == Delta::Kind::all || delta.kind == Delta::Kind::first_part) {
    whole_ = false;
    replicas_.tables_.erase(relation_.name);
    replicas_.tables_.try_emplace(relation_.name, relation_);
  }
  store::FactTable& table = replicas_.tables_.find(relation_.name)->second;
  for (const Fact& fact : delta.removed.facts) {
    if (store::StandingFact* gone = table.find(fact.id)) table.remove(*gone, delta.revision);
  }
  for (Fact& fact : delta.added.facts) {
    const Result<void> shaped = check_shape(relation_, fact.datum);
    if (!shaped) return shaped;
    if (table.find(fact.id) != nullptr || table.find_key_of(fact.datum) != nullptr) {
      return fail("bad-frame", "the board said that two facts have one key", fact.datum);
    }
    table.insert({std::move(fact)});
  }
  revision_ = delta.revision;
  if (delta.kind == Delta::Kind::all || delta.kind == Delta::Kind::last_part) whole_ = true;
  if (whole_) known_.set();
  return {};
}

}  // namespace pizarra::client
