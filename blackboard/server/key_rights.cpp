#include "blackboard/server/key_rights.hpp"

#include <algorithm>
#include <set>

#include "blackboard/boards_own.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/store.hpp"

namespace pizarra::server {

namespace {

std::unexpected<Failure> may_not(const wire::PublicKey& key, const std::string& what, const Datum& subject) {
  return fail("not-permitted", "the key " + key.name + " may not " + what, subject);
}

// Tell, retract, take or read what the pattern is about.
std::unexpected<Failure> may_not_with_facts(const wire::PublicKey& key, const std::string& verb, const Datum& pattern) {
  const std::string relation(pattern.head());
  return may_not(key, verb + (relation.empty() ? " this" : " facts of " + relation), pattern);
}

// The pattern of facts with the same key as `fact`.
Datum pattern_of_key(const Relation& relation, const Datum& fact) {
  std::vector<Datum> pattern(fact.items().begin(), fact.items().end());
  for (std::size_t i = 1; i < pattern.size(); ++i) pattern[i] = "?"_sym;
  for (const std::size_t position : relation.key) pattern[position + 1] = fact[position + 1];
  return Datum::list(std::move(pattern));
}

// Of those that are called alike, so that one key does not take the board's room for relations.
constexpr std::int64_t most_alike = 256;

Result<void> check_room(const wire::PublicKey& key, const Relation& relation, const std::set<std::string>& declared) {
  if (declared.contains(relation.name)) return {};
  for (const auto* listed : {&key.may.tell, &key.may.take, &key.may.read}) {
    for (const std::string& pattern : *listed) {
      if (!pattern.ends_with('*') || pattern == "*" || !wire::permits({pattern}, relation.name)) continue;
      const auto alike = [&](const std::string& name) { return wire::permits({pattern}, name); };
      if (std::ranges::count_if(declared, alike) < most_alike) continue;
      return fail("too-large", "there are " + std::to_string(most_alike) + " relations called " + pattern + " already",
                  relation_to_datum(relation));
    }
  }
  return {};
}

}  // namespace

bool KeyRights::may_know(Key key, std::string_view relation) {
  return key == nullptr || wire::permits(key->may.tell, relation) || wire::permits(key->may.take, relation) ||
         wire::permits(key->may.read, relation);
}

Result<void> KeyRights::declare(Key key, const std::vector<Relation>& relations) const {
  if (key == nullptr) return {};
  std::set<std::string> declared;
  for (const auto& [name, table] : board_.store().tables()) declared.insert(name);
  for (const Relation& relation : relations) {
    if (!may_know(key, relation.name)) return may_not(*key, "declare " + relation.name, relation_to_datum(relation));
    const Result<void> room = check_room(*key, relation, declared);
    if (!room) return room;
    declared.insert(relation.name);
  }
  return {};
}

Result<void> KeyRights::transact(Key key, const Transaction& transaction, std::size_t& examined) const {
  if (key == nullptr) return {};
  for (const Transaction::Precondition& precondition : transaction.preconditions) {
    const Result<void> checked = check(*key, precondition);
    if (!checked) return checked;
  }
  for (const Transaction::Step& step : transaction.steps) {
    const Result<void> checked = check(*key, step, examined);
    if (!checked) return checked;
  }
  return {};
}

// Whether a transaction happened says something of what its preconditions name.
Result<void> KeyRights::check(const wire::PublicKey& key, const Transaction::Precondition& precondition) const {
  const Datum& pattern = std::visit([](const auto& p) -> const Datum& { return p.pattern; }, precondition);
  if (wire::permits(key.may.read, pattern.head()) || wire::permits(key.may.tell, pattern.head())) return {};
  return may_not_with_facts(key, "read", pattern);
}

Result<void> KeyRights::check(const wire::PublicKey& key, const Transaction::Step& step, std::size_t& examined) const {
  if (const auto* settle = std::get_if<Transaction::Settle>(&step)) {
    const LeaseId holder = board_.store().holder_of(settle->taken);
    return holder == 0 ? Result<void>() : use_lease(&key, holder);
  }
  const auto* tell = std::get_if<Transaction::Tell>(&step);
  const Datum& datum = tell != nullptr ? tell->fact : std::get<Transaction::Retract>(step).pattern;
  if (!wire::permits(key.may.tell, datum.head()))
    return may_not_with_facts(key, tell != nullptr ? "tell" : "retract", datum);
  if (tell != nullptr && tell->lease != 0) {
    const Result<void> own = use_lease(&key, tell->lease);
    if (!own) return own;
  }
  if (wire::permits(key.may.override_leases, datum.head())) return {};
  const auto table = board_.store().tables().find(datum.head());
  // The board refuses what has no relation or not its shape.
  if (table == board_.store().tables().end()) return {};
  if (tell == nullptr) return leave_to_others(key, datum, datum, examined);
  if (!check_shape(table->second.relation(), datum)) return {};
  return leave_to_others(key, datum, pattern_of_key(table->second.relation(), datum), examined);
}

Result<void> KeyRights::leave_to_others(const wire::PublicKey& key, const Datum& told, const Datum& pattern,
                                        std::size_t& examined) const {
  const store::FactTable& table = board_.store().tables().find(pattern.head())->second;
  if (!check_pattern_shape(table.relation(), pattern)) return {};
  std::string other;
  {
    store::Looking looking(examined);
    table.visit(pattern, [&](const Fact& fact) {
      Bindings bindings;
      const bool leased = board_.store().lease_of(fact.id) != 0;
      const bool of_other = leased && !wire::may_call_itself(key.name, fact.teller);
      if (of_other && match(pattern, fact.datum, bindings)) other = fact.teller;
      return other.empty() && looking.at_one_more();
    });
  }
  const Result<void> cheap = store::check_looking(examined, told);
  if (!cheap) return cheap;
  if (other.empty()) return {};
  return may_not(key, "replace or retract what " + other + " told under its lease", told);
}

Result<void> KeyRights::ask(Key key, const Query& query) const {
  if (key == nullptr) return {};
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind == Query::Clause::Kind::compare || wire::permits(key->may.read, clause.form.head())) continue;
    if (clause.form.head() == own_permission || clause.form.head() == provenance) continue;
    return may_not_with_facts(*key, "read", clause.form);
  }
  return {};
}

Result<void> KeyRights::take(Key key, const Datum& pattern, LeaseId holder) const {
  if (key == nullptr) return {};
  if (!wire::permits(key->may.take, pattern.head())) return may_not_with_facts(*key, "take", pattern);
  return holder == 0 ? Result<void>() : use_lease(key, holder);
}

Result<void> KeyRights::use_lease(Key key, LeaseId lease) const {
  // One that has lapsed is the board's to refuse.
  if (key == nullptr || !board_.store().stands(lease)) return {};
  const auto own = leases_.find({key->name, true});
  if (own != leases_.end() && own->second.contains(lease)) return {};
  return may_not(*key, "use the lease of another", to_datum(lease));
}

Result<void> KeyRights::lease(Key key, const std::string& name) {
  const auto own = leases_.find({name, key != nullptr});
  if (own == leases_.end() || own->second.size() < most_leases) return {};
  forget_lapsed(own->second);
  if (own->second.size() < most_leases) return {};
  return fail("too-large",
              "the clients called " + name + " have " + std::to_string(most_leases) + " leases, the most there are",
              to_datum(name));
}

void KeyRights::forget_lapsed(std::set<LeaseId>& leases) const {
  std::erase_if(leases, [this](LeaseId lease) { return !board_.store().stands(lease); });
}

void KeyRights::sweep() {
  for (auto& [owner, leases] : leases_) forget_lapsed(leases);
  std::erase_if(leases_, [](const auto& owned) { return owned.second.empty(); });
}

}  // namespace pizarra::server
