#include "blackboard/store/transaction_check.hpp"

#include <algorithm>

#include "blackboard/boards_own.hpp"
#include "blackboard/limits.hpp"
#include "blackboard/store/capacity.hpp"
#include "blackboard/store/fitting.hpp"
#include "blackboard/store/looking.hpp"
#include "blackboard/store/query_tables.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::store {

namespace {

std::unexpected<Failure> not_met(std::string sentence, Datum subject) {
  return fail("precondition-failed", std::move(sentence), std::move(subject));
}

std::size_t heaviest_told(const Transaction& transaction) {
  std::size_t heaviest = 1;
  for (const Transaction::Step& step : transaction.steps) {
    const auto* tell = std::get_if<Transaction::Tell>(&step);
    if (tell != nullptr) heaviest = std::max(heaviest, pizarra::weigh(tell->fact).elements / Looking::elements_a_fact);
  }
  return heaviest;
}

}  // namespace

Result<void> TransactionCheck::all() {
  if (transaction_.steps.size() + transaction_.preconditions.size() > limits::steps) {
    return fail("too-large", "a transaction has at most " + std::to_string(limits::steps) + " steps and preconditions");
  }
  const Weight weight = weigh(transaction_);
  Result<void> checked = check_weight(weight, "the transaction");
  if (!checked) return checked;
  for (const auto& each : transaction_.preconditions) {
    checked = precondition(each);
    if (!checked) return checked;
  }
  for (const Transaction::Step& each : transaction_.steps) {
    checked = step(each);
    if (!checked) return checked;
  }
  // What is taken may come back.
  Load room{.facts = kept_.size() + kept_.held().size() - settled_.size(), .bytes = kept_.bytes()};
  for (const FactId id : settled_) room.bytes -= footprint(kept_.held().at(id).fact);
  return check_room(transaction_, weight, teller_, kept_.tables(), room);
}

Result<void> TransactionCheck::teller(const std::string& teller, const Relation& relation) {
  if (!is_told_by_the_board(relation.name) || teller == board_teller) return {};
  return fail(left_to_the_board(relation.name));
}

Result<void> TransactionCheck::precondition(const Transaction::Precondition& precondition) {
  const Datum& pattern = std::visit([](const auto& p) -> const Datum& { return p.pattern; }, precondition);
  const Result<const FactTable*> table = table_for(pattern, kept_.tables());
  if (!table) return fail(table);
  if (const auto* wanted = std::get_if<Transaction::Unchanged>(&precondition)) return unchanged(**table, *wanted);
  const bool wanted = std::holds_alternative<Transaction::Present>(precondition);
  const bool there = kept_.first_standing(**table, pattern, examined_) != nullptr;
  const Result<void> cheap = check_looking(examined_, pattern);
  if (!cheap) return cheap;
  if (there == wanted) return {};
  return not_met(wanted ? "no fact is like this" : "there is a fact like this", pattern);
}

Result<void> TransactionCheck::unchanged(const FactTable& table, const Transaction::Unchanged& wanted) {
  const auto& [pattern, revision] = wanted;
  if (revision > kept_.revision()) {
    return not_met(
        "revision " + std::to_string(revision) + " has not been; the board is at " + std::to_string(kept_.revision()),
        pattern);
  }
  const bool stands = is_unchanged(table, pattern, revision, examined_);
  const Result<void> cheap = check_looking(examined_, pattern);
  if (!cheap || stands) return cheap;
  return not_met("changed since revision " + std::to_string(revision), pattern);
}

Result<void> TransactionCheck::step(const Transaction::Step& step) {
  if (const auto* settle = std::get_if<Transaction::Settle>(&step)) return settling(settle->taken);
  if (const auto* tell = std::get_if<Transaction::Tell>(&step)) return telling(*tell);
  return retracting(std::get<Transaction::Retract>(step).pattern);
}

Result<void> TransactionCheck::settling(FactId taken) {
  if (kept_.held().contains(taken) && settled_.insert(taken).second) return {};
  return not_met("fact " + std::to_string(taken) + " is not taken, or was put back", to_datum(taken));
}

Result<void> TransactionCheck::turn_to(const Datum& datum) {
  if (table_ != nullptr && datum.head() == table_->relation().name) return {};
  const Result<const FactTable*> table = table_named_by(datum, kept_.tables());
  if (!table) return fail(table);
  Result<void> allowed = teller(teller_, (*table)->relation());
  if (allowed) table_ = *table;
  return allowed;
}

Result<void> TransactionCheck::telling(const Transaction::Tell& tell) {
  const Result<void> turned = turn_to(tell.fact);
  if (!turned) return turned;
  const Result<void> shaped = check_shape(table_->relation(), tell.fact);
  if (!shaped) return shaped;
  ++told_[table_];
  // One that it replaces leaves them.
  examined_ += 2 * table_->looks_of_indexes();
  if (examined_ > limits::examined) {
    return fail("too-costly", "the relations told of have many indexes; tell fewer facts at once", tell.fact);
  }
  if (tell.lease != 0 && !kept_.leases().contains(tell.lease)) return unknown_lease(tell.lease);
  return {};
}

Result<void> TransactionCheck::retracting(const Datum& pattern) {
  const Result<void> turned = turn_to(pattern);
  if (!turned) return turned;
  const Result<void> shaped = check_pattern_shape(table_->relation(), pattern);
  if (!shaped) return shaped;
  const std::size_t going = look_for_all(*table_, pattern, examined_);
  const bool is_few = table_->key_is_ground(pattern);
  examined_ += going * (is_few ? table_->looks_of_indexes() : table_->looks_to_remove());
  examined_ += looks_at_told(pattern);
  const Result<void> cheap = check_looking(examined_, pattern);
  if (cheap || cheap.error().symbol != "too-costly") return cheap;
  return fail("too-costly",
              cheap.error().sentence + "; ask for some with (limit COUNT) and retract these by their keys", pattern);
}

std::size_t TransactionCheck::looks_at_told(const Datum& pattern) {
  const auto own = told_.find(table_);
  if (own == told_.end() || table_->key_is_ground(pattern)) return 0;
  if (!compares_much(pattern)) return own->second;
  if (heaviest_ == 0) heaviest_ = heaviest_told(transaction_);
  return own->second * heaviest_;
}

}  // namespace pizarra::store
