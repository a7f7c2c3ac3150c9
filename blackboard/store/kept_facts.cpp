#include "blackboard/store/kept_facts.hpp"

#include "blackboard/store/capacity.hpp"
#include "blackboard/store/fitting.hpp"

namespace pizarra::store {

std::unexpected<Failure> unknown_lease(LeaseId lease) {
  return fail("unknown-lease", "lease " + std::to_string(lease) + " has lapsed, or never was", to_datum(lease));
}

void KeptFacts::commit(const Commit& commit) {
  revision_ = commit.revision;
  if (on_commit) on_commit(commit);
}

StandingFact* KeptFacts::find(FactId standing) const {
  return standing_.find(standing, [](const StandingFact&) { return true; });
}

StandingFact& KeptFacts::put(FactTable& table, Fact fact) {
  const std::size_t before = table.bytes();
  StandingFact& standing = table.insert({std::move(fact)});
  bytes_ += table.bytes() - before;
  standing_.insert(standing.fact.id, &standing);
  return standing;
}

Fact KeptFacts::replace(StandingFact& standing, Fact fact) {
  standing_.erase(standing.fact.id, &standing);
  standing_.insert(fact.id, &standing);
  const std::size_t before = standing.table->bytes();
  Fact former = standing.table->replace(standing, std::move(fact));
  bytes_ += standing.table->bytes() - before;
  return former;
}

StandingFact KeptFacts::remove(StandingFact& standing, Revision revision) {
  standing_.erase(standing.fact.id, &standing);
  FactTable& table = *standing.table;
  const std::size_t before = table.bytes();
  StandingFact gone = table.remove(standing, revision);
  bytes_ -= before - table.bytes();
  return gone;
}

void KeptFacts::hold(Held held) {
  bytes_ += footprint(held.fact);
  const FactId id = held.fact.id;
  held_[id] = std::move(held);
}

KeptFacts::Held KeptFacts::let_go(FactId taken) {
  Held held = std::move(held_.extract(taken).mapped());
  bytes_ -= footprint(held.fact);
  return held;
}

LeaseId KeptFacts::lease_of(FactId standing) const {
  const StandingFact* found = find(standing);
  return found == nullptr ? 0 : found->lease;
}

LeaseId KeptFacts::holder_of(FactId taken) const {
  const auto held = held_.find(taken);
  return held == held_.end() ? 0 : held->second.holder;
}

bool KeptFacts::is_to_go(FactId standing) const {
  const LeaseId lease = lease_of(standing);
  return lease != 0 && !leases_.contains(lease);
}

// While nothing lapses, all that is there stands.
const Fact* KeptFacts::first_standing(const FactTable& table, const Datum& pattern, std::size_t& examined) const {
  if (!some_lapse_) return first_fit(table, pattern, examined);
  return first_fit(table, pattern, examined, [this](const Fact& fact) { return !is_to_go(fact.id); });
}

void KeptFacts::restore_counters(Revision revision, FactId next_id) {
  revision_ = revision;
  next_id_ = std::max(next_id_, next_id);
  horizon_ = revision;
  for (auto& [name, table] : tables_) table.forget_removals(horizon_);
}

}  // namespace pizarra::store
