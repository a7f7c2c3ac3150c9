// How a store repeats what a journal tells it, and comes back to life from it.

#include "blackboard/evaluate.hpp"
#include "blackboard/store.hpp"
#include "blackboard/store_change.hpp"

namespace pizarra {

using Kind = Commit::Entry::Kind;

namespace {

std::unexpected<Failure> impossible(const Commit& commit, std::string sentence, Datum subject) {
  return fail("bad-journal", "revision " + std::to_string(commit.revision) + ": " + std::move(sentence),
              std::move(subject));
}

}  // namespace

Result<void> Store::apply(const Commit& commit) {
  if (commit.revision <= revision_) return impossible(commit, "revisions only grow", to_datum(revision_));
  for (const Commit::Entry& entry : commit.entries) {
    Result<void> applied = apply_entry(commit, entry);
    if (!applied) return applied;
  }
  revision_ = commit.revision;
  return {};
}

Result<void> Store::apply_entry(const Commit& commit, const Commit::Entry& entry) {
  Fact fact = entry.fact;
  if (entry.kind == Kind::settled || entry.kind == Kind::returned) {
    const auto held = held_.find(entry.kind == Kind::settled ? fact.id : entry.former);
    if (held == held_.end()) return impossible(commit, "this fact was not taken", to_datum(fact.id));
    if (entry.kind == Kind::returned) {
      fact = held->second.fact;
      fact.id = entry.fact.id;
      fact.revision = commit.revision;
    }
    held_.erase(held);
    if (entry.kind == Kind::settled) return {};
  }
  if (removes(entry)) {
    const auto home = homes_.find(fact.id);
    if (home == homes_.end()) return impossible(commit, "there is no such fact", to_datum(fact.id));
    FactTable::Entry removed = home->second->remove(fact.id, commit.revision);
    homes_.erase(home);
    if (entry.kind == Kind::taken) held_[fact.id] = {std::move(removed.fact), 0};
    return {};
  }
  const Result<const FactTable*> found = table_for(fact.datum, tables_);
  if (!found) return impossible(commit, found.error().sentence, fact.datum);
  FactTable& table = tables_.find(fact.datum.head())->second;
  const Result<void> shaped = check_shape(table.relation(), fact.datum);
  if (!shaped) return impossible(commit, shaped.error().sentence, fact.datum);
  if (fact.id < next_fact_ || table.find_key_of(fact.datum) != nullptr) {
    return impossible(commit, "a fact with this id or key stands already", fact.datum);
  }
  next_fact_ = fact.id + 1;
  homes_[fact.id] = &table;
  table.insert({std::move(fact)});
  return {};
}

void Store::resume(Time now) {
  Change change(*this, "board", now);
  for (auto& [name, table] : tables_) {
    std::vector<FactId> passing;
    for (const auto& [id, entry] : table.entries()) {
      if (!table.relation().durable) passing.push_back(id);
    }
    for (const FactId id : passing) change.retract(id);
    if (!table.relation().lease) continue;
    for (const auto& [id, entry] : table.entries()) {
      table.find(id)->expiry = now + *table.relation().lease;
      fact_expiries_.emplace(now + *table.relation().lease, id);
    }
  }
  while (!held_.empty()) {
    const auto& [id, held] = *held_.begin();
    if (tables_.find(held.fact.datum.head())->second.relation().durable) {
      change.put_back(id);
    } else {
      change.settle(id);
    }
  }
  change.finish();
}

}  // namespace pizarra
