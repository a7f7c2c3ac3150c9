#include "blackboard/store/store.hpp"

#include <algorithm>

#include "blackboard/boards_own.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/store/capacity.hpp"
#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/fitting.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/query_tables.hpp"
#include "blackboard/store/store_change.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::store {

namespace {

constexpr Duration longest_lease = std::chrono::hours(24 * 365);
std::unexpected<Failure> not_met(std::string sentence, Datum subject) {
  return fail("precondition-failed", std::move(sentence), std::move(subject));
}

std::unexpected<Failure> costly_tells(const Datum& subject) {
  return fail("too-costly", "the relations told of have many indexes; tell fewer facts at once", subject);
}

std::size_t heaviest_told(const Transaction& transaction) {
  std::size_t heaviest = 1;
  for (const Transaction::Step& step : transaction.steps) {
    const auto* tell = std::get_if<Transaction::Tell>(&step);
    if (tell != nullptr) heaviest = std::max(heaviest, pizarra::weigh(tell->fact).elements / Looking::elements_a_fact);
  }
  return heaviest;
}

Result<void> check_teller(const std::string& teller, const Relation& relation) {
  if (!is_told_by_the_board(relation.name) || teller == board_teller) return {};
  return fail(left_to_the_board(relation.name));
}

}  // namespace

std::unexpected<Failure> Store::unknown_lease(LeaseId lease) {
  return fail("unknown-lease", "lease " + std::to_string(lease) + " has lapsed, or never was", to_datum(lease));
}

Result<std::vector<Relation>> Store::declare(const std::vector<Relation>& relations) {
  std::vector<Relation> fresh;
  for (const Relation& relation : relations) {
    // Through its form, so that one put together in C++ is checked like one that was read.
    const Result<Relation> checked = relation_from_datum(relation_to_datum(relation));
    if (!checked) return fail(checked);
    const auto standing = tables_.find(relation.name);
    if (standing == tables_.end()) {
      fresh.push_back(*checked);
    } else if (standing->second.relation() != *checked) {
      return fail("wrong-shape", "the relation " + relation.name + " is declared differently already",
                  relation_to_datum(standing->second.relation()));
    }
  }
  if (tables_.size() + fresh.size() > limits::relations) return fail("too-large", "the board has too many relations");
  for (const Relation& relation : fresh) {
    tables_.try_emplace(relation.name, relation).first->second.forget_removals(horizon_);
  }
  return fresh;
}

Result<void> Store::check_precondition(const Transaction::Precondition& precondition, std::size_t& examined) const {
  const Datum& pattern = std::visit([](const auto& p) -> const Datum& { return p.pattern; }, precondition);
  const Result<const FactTable*> table = table_for(pattern, tables_);
  if (!table) return fail(table);
  if (const auto* unchanged = std::get_if<Transaction::Unchanged>(&precondition)) {
    if (unchanged->revision > revision_) {
      return not_met("revision " + std::to_string(unchanged->revision) + " has not been; the board is at " +
                         std::to_string(revision_),
                     pattern);
    }
    const bool stands = is_unchanged(**table, pattern, unchanged->revision, examined);
    const Result<void> cheap = check_looking(examined, pattern);
    if (!cheap || stands) return cheap;
    return not_met("changed since revision " + std::to_string(unchanged->revision), pattern);
  }
  const bool wanted = std::holds_alternative<Transaction::Present>(precondition);
  const bool there = first_standing(**table, pattern, examined) != nullptr;
  const Result<void> cheap = check_looking(examined, pattern);
  if (!cheap) return cheap;
  if (there == wanted) return {};
  return not_met(wanted ? "no fact is like this" : "there is a fact like this", pattern);
}

// The findings about a transaction before its next step.
struct Store::Checked {
  const std::string& teller;
  const Transaction& transaction;
  std::size_t& examined;
  const FactTable* table = nullptr;  // that the last step was about, as most of those after it are
  std::set<FactId> settled = {};
  // A transaction's own retractions will look at the facts that it tells: counted before anything is done, since
  // nothing is undone.
  std::map<const FactTable*, std::size_t> told = {};
  std::size_t heaviest = 0;  // as how many facts looking at one of them may count; 0 before that was asked

  std::size_t looks_at_told(const Datum& pattern);
};

std::size_t Store::Checked::looks_at_told(const Datum& pattern) {
  const auto own = told.find(table);
  if (own == told.end() || table->key_is_ground(pattern)) return 0;
  if (!compares_much(pattern)) return own->second;
  if (heaviest == 0) heaviest = heaviest_told(transaction);
  return own->second * heaviest;
}

Result<void> Store::check_step(const Transaction::Step& step, Checked& before) {
  if (const auto* settle = std::get_if<Transaction::Settle>(&step)) {
    if (held_.contains(settle->taken) && before.settled.insert(settle->taken).second) return {};
    return not_met("fact " + std::to_string(settle->taken) + " is not taken, or was put back", to_datum(settle->taken));
  }
  const auto* tell = std::get_if<Transaction::Tell>(&step);
  const Datum& datum = tell != nullptr ? tell->fact : std::get<Transaction::Retract>(step).pattern;
  if (before.table == nullptr || datum.head() != before.table->relation().name) {
    const Result<const FactTable*> table = table_named_by(datum, tables_);
    if (!table) return fail(table);
    const Result<void> allowed = check_teller(before.teller, (*table)->relation());
    if (!allowed) return allowed;
    before.table = *table;
  }
  const Relation& relation = before.table->relation();
  Result<void> shaped = tell != nullptr ? check_shape(relation, datum) : check_pattern_shape(relation, datum);
  if (!shaped) return shaped;
  if (tell == nullptr) {
    const std::size_t going = look_for_all(*before.table, datum, before.examined);
    const bool is_few = before.table->key_is_ground(datum);
    before.examined += going * (is_few ? before.table->looks_of_indexes() : before.table->looks_to_remove());
    before.examined += before.looks_at_told(datum);
    const Result<void> cheap = check_looking(before.examined, datum);
    if (cheap || cheap.error().symbol != "too-costly") return cheap;
    return fail("too-costly",
                cheap.error().sentence + "; ask for some with (limit COUNT) and retract these by their keys", datum);
  }
  ++before.told[before.table];
  // One that it replaces leaves them.
  before.examined += 2 * before.table->looks_of_indexes();
  if (before.examined > limits::examined) return costly_tells(datum);
  if (tell->lease != 0 && leases_.find(tell->lease) == nullptr) return unknown_lease(tell->lease);
  return {};
}

Result<void> Store::check(const std::string& teller, const Transaction& transaction, std::size_t& examined) {
  if (transaction.steps.size() + transaction.preconditions.size() > limits::steps) {
    return fail("too-large", "a transaction has at most " + std::to_string(limits::steps) + " steps and preconditions");
  }
  const Weight weight = weigh(transaction);
  Result<void> checked = check_weight(weight, "the transaction");
  if (!checked) return checked;
  for (const auto& precondition : transaction.preconditions) {
    checked = check_precondition(precondition, examined);
    if (!checked) return checked;
  }
  Checked before{.teller = teller, .transaction = transaction, .examined = examined};
  for (const Transaction::Step& step : transaction.steps) {
    checked = check_step(step, before);
    if (!checked) return checked;
  }
  // What is taken may come back.
  Load room{.facts = size() + held_.size() - before.settled.size(), .bytes = bytes_};
  for (const FactId id : before.settled) room.bytes -= footprint(held_.at(id).fact);
  return check_room(transaction, weight, teller, tables_, room);
}

Result<Revision> Store::transact(const std::string& teller, const Transaction& transaction, Time now,
                                 std::size_t& examined) {
  const Result<void> checked = check(teller, transaction, examined);
  if (!checked) return fail(checked);
  // As it was looked at, it is done.
  const Indexing no_more(Indexing::May::not_make);
  Change change(*this, teller, now);
  change.expect(transaction.steps.size());
  for (const Transaction::Step& step : transaction.steps) {
    if (const auto* tell = std::get_if<Transaction::Tell>(&step)) change.tell(tell->fact, tell->because, tell->lease);
    if (const auto* retract = std::get_if<Transaction::Retract>(&step)) change.retract_matching(retract->pattern);
    if (const auto* settle = std::get_if<Transaction::Settle>(&step)) change.settle(settle->taken);
  }
  return change.finish();
}

Result<Answers> Store::ask(const Query& query, std::size_t& examined) const {
  if (query.at) return fail("no-history", "this board keeps no journal that could say what was");
  const Result<void> checked = check_query_on(query, tables_);
  if (!checked) return fail(checked);
  Result<std::vector<Answer>> answers = evaluate(query, tables_, examined);
  if (!answers) return fail(answers);
  return Answers{revision_, std::move(*answers)};
}

Result<std::optional<Fact>> Store::take(const std::string& teller, const Datum& pattern, LeaseId holder, Time now,
                                        std::size_t& examined) {
  const Result<void> light = check_weight(pizarra::weigh(pattern), "the pattern");
  if (!light) return fail(light);
  const Result<const FactTable*> table = table_for(pattern, tables_);
  if (!table) return fail(table);
  const Result<void> allowed = check_teller(teller, (*table)->relation());
  if (!allowed) return fail(allowed);
  if (holder != 0 && leases_.find(holder) == nullptr) return unknown_lease(holder);
  const Fact* fact = first_standing(**table, pattern, examined);
  const Result<void> cheap = check_looking(examined, pattern);
  if (!cheap) return fail(cheap);
  if (fact == nullptr) return std::nullopt;
  Change change(*this, teller, now);
  Fact taken = change.take(fact->id, holder);
  change.finish();
  return taken;
}

// While nothing lapses, all that is there stands.
const Fact* Store::first_standing(const FactTable& table, const Datum& pattern, std::size_t& examined) const {
  if (lapsing_.empty()) return first_fit(table, pattern, examined);
  return first_fit(table, pattern, examined, [this](const Fact& fact) { return !is_to_go(fact.id); });
}

bool Store::is_to_go(FactId standing) const {
  const LeaseId lease = lease_of(standing);
  return lease != 0 && !leases_.contains(lease);
}

const Fact* Store::held(FactId id) const {
  const auto found = held_.find(id);
  return found == held_.end() ? nullptr : &found->second.fact;
}

const Fact* Store::fact(FactId id) const {
  const StandingFact* standing = find(id);
  return standing == nullptr ? held(id) : &standing->fact;
}

Result<LeaseId> Store::lease(Duration length, Time now) {
  if (length <= Duration::zero() || length > longest_lease) {
    return fail("wrong-shape", "a lease is longer than 0 and at most a year", to_datum(length.count()));
  }
  if (leases_.size() >= limits::leases) return fail("too-large", "the board has too many leases");
  return leases_.grant(length, now);
}

Result<void> Store::renew(LeaseId lease, Time now) {
  if (leases_.find(lease) == nullptr) return unknown_lease(lease);
  leases_.renew(lease, now);
  return {};
}

LeaseId Store::lease_of(FactId standing) const {
  const StandingFact* found = find(standing);
  return found == nullptr ? 0 : found->lease;
}

StandingFact* Store::find(FactId standing) const {
  return standing_.find(standing, [](const StandingFact&) { return true; });
}

StandingFact& Store::put(FactTable& table, Fact fact) {
  const std::size_t before = table.bytes();
  StandingFact& standing = table.insert({std::move(fact)});
  bytes_ += table.bytes() - before;
  standing_.insert(standing.fact.id, &standing);
  return standing;
}

Fact Store::replace(StandingFact& standing, Fact fact) {
  standing_.erase(standing.fact.id, &standing);
  standing_.insert(fact.id, &standing);
  const std::size_t before = standing.table->bytes();
  Fact former = standing.table->replace(standing, std::move(fact));
  bytes_ += standing.table->bytes() - before;
  return former;
}

StandingFact Store::remove(StandingFact& standing, Revision revision) {
  standing_.erase(standing.fact.id, &standing);
  FactTable& table = *standing.table;
  const std::size_t before = table.bytes();
  StandingFact gone = table.remove(standing, revision);
  bytes_ -= before - table.bytes();
  return gone;
}

void Store::hold(Held held) {
  bytes_ += footprint(held.fact);
  const FactId id = held.fact.id;
  held_[id] = std::move(held);
}

Store::Held Store::let_go(FactId taken) {
  Held held = std::move(held_.extract(taken).mapped());
  bytes_ -= footprint(held.fact);
  return held;
}

LeaseId Store::holder_of(FactId taken) const {
  const auto held = held_.find(taken);
  return held == held_.end() ? 0 : held->second.holder;
}

}  // namespace pizarra::store
