#include "agents/coordinator/perceive/belief_teller.hpp"

#include "agents/coordinator/retried_commit.hpp"
#include "agents/runtime/follow.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::coordinator {

namespace {

// However often others change what is believed, it is put right no more often.
constexpr Duration put_right_pause = 100ms;
// A mark that moved less is not told anew.
constexpr double told_again_mm = 1;

// A belief is told as itself and as (believed BELIEF).
const Datum& belief_in(const Datum& fact) { return fact.is_form("believed") ? fact[1] : fact; }

}  // namespace

void BeliefTeller::start() {
  const Datum any = "?"_sym;
  std::vector<Datum> patterns{list("believed"_sym, any)};
  for (const forms::Predicate& predicate : domain_.domain().predicates) {
    std::vector<Datum> pattern{Datum::symbol(predicate.name)};
    pattern.resize(1 + predicate.arguments.size(), any);
    patterns.push_back(Datum::list(std::move(pattern)));
  }
  for (const Datum& pattern : patterns) {
    const auto take = [this, pattern](Change change) { return put_right(pattern, std::move(change)); };
    jobs_.push_back(context_.executor.spawn(runtime::follow(context_, pattern, take)));
  }
}

Task<void> BeliefTeller::tell(const Sightings& sightings, Beliefs::Change change, FactId look) {
  if (service_.presence() != told_under_) {
    // A board that began anew knows nothing of what was told before.
    told_under_ = service_.presence();
    told_places_.clear();
    all_told_ = false;
  }
  if (!all_told_) change.come.assign(beliefs_.facts().begin(), beliefs_.facts().end());
  Transaction transaction;
  add_places(transaction, sightings, look);
  add_beliefs(transaction, change);
  if (transaction.steps.empty()) co_return;
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  // Where the presence lapsed meanwhile, all is told anew once it is back.
  all_told_ = told.has_value();
  if (!told) told_places_.clear();
}

void BeliefTeller::add_places(Transaction& transaction, const Sightings& sightings, FactId look) {
  const Datum any = "?"_sym;
  for (const auto& [name, sighting] : sightings.all()) {
    const auto told = told_places_.find(name);
    const bool recent = sightings.remembered(name, options_.grace_looks);
    if (!recent) {
      if (told == told_places_.end()) continue;
      transaction.retract(list("place"_sym, Datum::symbol(name), any, any, any, any));
      told_places_.erase(told);
      continue;
    }
    const Eigen::Vector3d& at = sighting.place_mm;
    if (told != told_places_.end() && (told->second - at).norm() < told_again_mm) continue;
    const Datum symbol = Datum::symbol(name);
    transaction.tell(
        list("place"_sym, symbol, rounded(at.x(), 10), rounded(at.y(), 10), rounded(at.z(), 10), sighting.frame),
        {look}, service_.presence());
    told_places_.insert_or_assign(name, at);
  }
}

void BeliefTeller::add_beliefs(Transaction& transaction, const Beliefs::Change& change) const {
  for (const Datum& fact : change.gone) {
    transaction.retract(list("believed"_sym, fact));
    transaction.retract(fact);
  }
  for (const Datum& fact : change.come) {
    add_fact(transaction, list("believed"_sym, fact));
    add_fact(transaction, fact);
  }
}

void BeliefTeller::add_fact(Transaction& transaction, const Datum& fact) const {
  transaction.tell(fact, {beliefs_.changed_in(belief_in(fact)).look}, service_.presence());
}

bool BeliefTeller::is_to_be_told(const Datum& fact) const { return beliefs_.facts().contains(belief_in(fact)); }

Facts BeliefTeller::to_be_told(const Datum& pattern) const {
  Facts facts;
  for (const Datum& belief : beliefs_.facts()) {
    if (pattern.is_form("believed")) facts.insert(list("believed"_sym, belief));
    if (pattern.is_form(belief.head())) facts.insert(belief);
  }
  return facts;
}

// What is told here shows as a change too; by then it is believed, or no longer.
Task<void> BeliefTeller::put_right(Datum pattern, Change change) {
  Facts standing;
  Facts lost;
  for (const Answer& answer : change.added) standing.insert(answer.facts.front().datum);
  for (const Answer& answer : change.removed) lost.insert(answer.facts.front().datum);
  if (change.resynchronised) lost = to_be_told(pattern);
  Transaction transaction;
  for (const Datum& fact : standing) {
    if (!is_to_be_told(fact)) transaction.retract(fact);
  }
  for (const Datum& fact : lost) {
    if (is_to_be_told(fact) && !standing.contains(fact)) add_fact(transaction, fact);
  }
  if (transaction.steps.empty()) co_return;
  // Where it fails the presence has lapsed, and all is told anew once it is back.
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  if (!told) all_told_ = false;
  co_await sleep(context_.executor, put_right_pause);
}

}  // namespace pizarra::coordinator
