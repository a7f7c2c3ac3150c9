// How a store repeats what a journal tells it.

#include "blackboard/store/query_tables.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::store {

using Kind = Commit::Entry::Kind;

namespace {

// That of a standing fact whose lease ended with the board that gave it.
constexpr LeaseId lease_of_former_life = ~LeaseId{0};

std::unexpected<Failure> impossible(const Commit& commit, std::string sentence, Datum subject) {
  return fail("bad-journal", "revision " + std::to_string(commit.revision) + ": " + std::move(sentence),
              std::move(subject));
}

}  // namespace

Result<void> Store::apply(Commit commit) {
  if (commit.revision <= revision_) return impossible(commit, "revisions only grow", to_datum(revision_));
  for (Commit::Entry& entry : commit.entries) {
    Result<void> applied = apply_entry(commit, entry);
    if (!applied) return applied;
  }
  revision_ = commit.revision;
  if (on_commit) on_commit(commit);
  return {};
}

Result<void> Store::apply_entry(const Commit& commit, Commit::Entry& entry) {
  Fact& fact = entry.fact;
  if (entry.kind == Kind::settled || entry.kind == Kind::returned) {
    const auto held = held_.find(entry.kind == Kind::settled ? fact.id : entry.former);
    if (held == held_.end()) return impossible(commit, "this fact was not taken", to_datum(fact.id));
    const FactId id = fact.id;
    fact = let_go(held->first).fact;
    if (entry.kind == Kind::settled) return {};
    fact.id = id;
    fact.revision = commit.revision;
  }
  if (entry.kind == Kind::leased || entry.kind == Kind::kept) {
    StandingFact* standing = find(fact.id);
    if (standing == nullptr) return impossible(commit, "there is no such fact", to_datum(fact.id));
    standing->lease = entry.kind == Kind::leased ? lease_of_former_life : 0;
    fact = standing->fact;
    return {};
  }
  if (removes(entry)) {
    StandingFact* standing = find(fact.id);
    if (standing == nullptr) return impossible(commit, "there is no such fact", to_datum(fact.id));
    const LeaseId told_under = standing->lease;
    fact = remove(*standing, commit.revision).fact;
    if (entry.kind == Kind::taken) hold({fact, 0, told_under});
    return {};
  }
  const Result<void> restored = restore(fact, entry.under_lease ? Restored::leased : Restored::standing);
  if (!restored) return impossible(commit, restored.error().sentence, restored.error().subject);
  return {};
}

Result<void> Store::restore(Fact fact, Restored as) {
  const Result<const FactTable*> found = table_for(fact.datum, tables_);
  if (!found) return fail(found);
  FactTable& table = tables_.find(fact.datum.head())->second;
  const Result<void> shaped = check_shape(table.relation(), fact.datum);
  if (!shaped) return shaped;
  const bool taken = as == Restored::taken || as == Restored::taken_leased;
  const bool leased = as == Restored::leased || as == Restored::taken_leased;
  const LeaseId told_under = leased ? lease_of_former_life : 0;
  const bool free = fact.id >= next_fact_ && (taken || table.find_key_of(fact.datum) == nullptr);
  if (!free) return fail("bad-journal", "a fact with this id or key stands already", fact.datum);
  next_fact_ = fact.id + 1;
  if (taken) {
    hold({std::move(fact), 0, told_under});
    return {};
  }
  put(table, std::move(fact)).lease = told_under;
  return {};
}

void Store::restore_counters(Revision revision, FactId next_fact) {
  revision_ = revision;
  next_fact_ = std::max(next_fact_, next_fact);
  horizon_ = revision;
  for (auto& [name, table] : tables_) table.forget_removals(horizon_);
}

std::vector<std::pair<Fact, bool>> Store::taken() const {
  std::vector<std::pair<Fact, bool>> all;
  for (const auto& [id, held] : held_) all.emplace_back(held.fact, held.told_under != 0);
  return all;
}

}  // namespace pizarra::store
