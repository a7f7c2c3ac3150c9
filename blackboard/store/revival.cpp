#include "blackboard/store/revival.hpp"

#include "blackboard/store/query_tables.hpp"
#include "blackboard/store/transaction_change.hpp"

namespace pizarra::store {

using Kind = Commit::Entry::Kind;

namespace {

// That of a standing fact whose lease ended with the board that gave it.
constexpr LeaseId lease_of_former_life = ~LeaseId{0};

std::unexpected<Failure> impossible(const Commit& commit, std::string sentence, Datum subject) {
  return fail("bad-journal", "revision " + std::to_string(commit.revision) + ": " + std::move(sentence),
              std::move(subject));
}

Result<void> apply_entry(KeptFacts& kept, const Commit& commit, Commit::Entry& entry) {
  Fact& fact = entry.fact;
  if (entry.kind == Kind::settled || entry.kind == Kind::returned) {
    const auto held = kept.held().find(entry.kind == Kind::settled ? fact.id : entry.former);
    if (held == kept.held().end()) return impossible(commit, "this fact was not taken", to_datum(fact.id));
    const FactId id = fact.id;
    fact = kept.let_go(held->first).fact;
    if (entry.kind == Kind::settled) return {};
    fact.id = id;
    fact.revision = commit.revision;
  }
  if (entry.kind == Kind::leased || entry.kind == Kind::kept) {
    StandingFact* standing = kept.find(fact.id);
    if (standing == nullptr) return impossible(commit, "there is no such fact", to_datum(fact.id));
    standing->lease = entry.kind == Kind::leased ? lease_of_former_life : 0;
    fact = standing->fact;
    return {};
  }
  if (removes(entry)) {
    StandingFact* standing = kept.find(fact.id);
    if (standing == nullptr) return impossible(commit, "there is no such fact", to_datum(fact.id));
    const LeaseId told_under = standing->lease;
    fact = kept.remove(*standing, commit.revision).fact;
    if (entry.kind == Kind::taken) kept.hold({fact, 0, told_under});
    return {};
  }
  const Result<void> restored = restore(kept, fact, entry.under_lease ? Restored::leased : Restored::standing);
  if (!restored) return impossible(commit, restored.error().sentence, restored.error().subject);
  return {};
}

}  // namespace

Result<void> apply(KeptFacts& kept, Commit commit) {
  if (commit.revision <= kept.revision()) return impossible(commit, "revisions only grow", to_datum(kept.revision()));
  for (Commit::Entry& entry : commit.entries) {
    Result<void> applied = apply_entry(kept, commit, entry);
    if (!applied) return applied;
  }
  kept.commit(commit);
  return {};
}

Result<void> restore(KeptFacts& kept, Fact fact, Restored as) {
  const Result<const FactTable*> found = table_for(fact.datum, kept.tables());
  if (!found) return fail(found);
  FactTable& table = kept.tables().find(fact.datum.head())->second;
  const Result<void> shaped = check_shape(table.relation(), fact.datum);
  if (!shaped) return shaped;
  const bool taken = as == Restored::taken || as == Restored::taken_leased;
  const bool leased = as == Restored::leased || as == Restored::taken_leased;
  const LeaseId told_under = leased ? lease_of_former_life : 0;
  const bool free = fact.id >= kept.next_id() && (taken || table.find_key_of(fact.datum) == nullptr);
  if (!free) return fail("bad-journal", "a fact with this id or key stands already", fact.datum);
  kept.restore_next_id(fact.id + 1);
  if (taken) {
    kept.hold({std::move(fact), 0, told_under});
    return {};
  }
  kept.put(table, std::move(fact)).lease = told_under;
  return {};
}

void resume(KeptFacts& kept, Time now) {
  TransactionChange change(kept, "board", now);
  for (auto& [name, table] : kept.tables()) {
    std::vector<FactId> passing;
    for (const StandingFact& standing : table.facts()) {
      if (!table.relation().durable || standing.lease != 0) passing.push_back(standing.fact.id);
    }
    for (const FactId id : passing) change.retract(id);
    if (!table.relation().lease) continue;
    for (const StandingFact& standing : table.facts()) {
      const FactId id = standing.fact.id;
      table.find(id)->expiry = now + *table.relation().lease;
      kept.expiries().emplace(now + *table.relation().lease, id);
    }
  }
  while (!kept.held().empty()) {
    const auto& [id, held] = *kept.held().begin();
    if (kept.tables().find(held.fact.datum.head())->second.relation().durable) {
      change.put_back(id);
    } else {
      change.settle(id);
    }
  }
  change.finish();
}

}  // namespace pizarra::store
