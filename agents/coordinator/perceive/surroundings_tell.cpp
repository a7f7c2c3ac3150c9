// What of the surroundings is told as facts.

#include <cmath>
#include <fmt/format.h>

#include "agents/coordinator/perceive/surroundings.hpp"
#include "agents/coordinator/retried_commit.hpp"
#include "agents/runtime/declared.hpp"

namespace pizarra::coordinator {

namespace {

// However often others change what is believed, it is put right no more often.
constexpr Duration put_right_pause = 100ms;
// A mark that moved less is not told anew.
constexpr double told_again_mm = 1;

double rounded(double mm) { return std::round(mm * 10) / 10; }

// A belief is told as itself and as (believed BELIEF).
const Datum& belief_in(const Datum& fact) { return fact.is_form("believed") ? fact[1] : fact; }

}  // namespace

void Surroundings::tell_places(Transaction& transaction) {
  const Datum any = "?"_sym;
  for (const auto& [name, sighting] : sightings_.all()) {
    const auto told = told_places_.find(name);
    const bool recent = sightings_.recent(name, grace_);
    if (!recent) {
      if (told == told_places_.end()) continue;
      transaction.retract(list("place"_sym, Datum::symbol(name), any, any, any, any));
      told_places_.erase(told);
      continue;
    }
    const Eigen::Vector3d& at = sighting.place_mm;
    if (told != told_places_.end() && (told->second - at).norm() < told_again_mm) continue;
    transaction.tell(
        list("place"_sym, Datum::symbol(name), rounded(at.x()), rounded(at.y()), rounded(at.z()), sighting.frame), {},
        service_.presence());
    told_places_.insert_or_assign(name, at);
  }
}

// The places from which a belief was concluded.
Task<std::vector<FactId>> Surroundings::evidence(Datum belief) {
  std::vector<FactId> ids;
  for (const Datum& object : belief.items().subspan(1)) {
    const Datum any = "?"_sym;
    const Datum pattern = list("place"_sym, object, any, any, any, any);
    const std::vector<Fact> places = co_await facts_now(context_.board, context_.executor, pattern);
    for (const Fact& place : places) ids.push_back(place.id);
  }
  co_return ids;
}

// Every look may fail in the same way; it is told once.
Task<void> Surroundings::tell_failure(Failure why) {
  if (told_failure_ == why.sentence) co_return;
  told_failure_ = why.sentence;
  const std::string sentence = fmt::format("the look cannot be understood, what was believed stays: {}", why.sentence);
  const Datum detail = failure_to_datum(why);
  co_await story_.tell("agent", sentence, detail);
}

Task<void> Surroundings::tell_change(Beliefs::Change change) {
  Transaction transaction;
  for (const Datum& fact : change.gone) {
    transaction.retract(list("believed"_sym, fact));
    transaction.retract(fact);
  }
  for (const Datum& fact : change.come) {
    const std::vector<FactId> because = co_await evidence(fact);
    const Datum believed = list("believed"_sym, fact);
    transaction.tell(believed, because, service_.presence());
    transaction.tell(fact, because, service_.presence());
  }
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  // Where the presence lapsed meanwhile, all is told anew once it is back.
  all_told_ = told.has_value();
  if (!told) told_places_.clear();
}

bool Surroundings::is_to_be_told(const Datum& fact) const { return beliefs().contains(belief_in(fact)); }

Facts Surroundings::to_be_told(const Datum& pattern) const {
  Facts facts;
  for (const Datum& belief : beliefs()) {
    if (pattern.is_form("believed")) facts.insert(list("believed"_sym, belief));
    if (pattern.is_form(belief.head())) facts.insert(belief);
  }
  return facts;
}

Task<void> Surroundings::keep_told(Datum pattern) {
  const Query query = query_for(pattern);
  while (true) {
    Result<std::unique_ptr<Watch>> watch = co_await runtime::watch_when_declared(context_.board, query);
    while (watch) {
      Result<Change> change = co_await (*watch)->next();
      if (!change) break;
      co_await put_right(pattern, std::move(*change));
    }
    co_await sleep(context_.executor, retry_pause);
  }
}

// What is told here shows as a change too; by then it is believed, or no longer.
Task<void> Surroundings::put_right(Datum pattern, Change change) {
  Facts standing;
  Facts lost;
  for (const Answer& answer : change.added) standing.insert(answer.facts.front().datum);
  for (const Answer& answer : change.removed) lost.insert(answer.facts.front().datum);
  if (change.resynchronised) lost = to_be_told(pattern);
  std::map<Datum, std::vector<FactId>> missing;
  for (const Datum& fact : lost) {
    const bool is_missing = is_to_be_told(fact) && !standing.contains(fact);
    if (!is_missing) continue;
    std::vector<FactId> because = co_await evidence(belief_in(fact));
    missing.emplace(fact, std::move(because));
  }
  Transaction transaction;
  for (const Datum& fact : standing) {
    if (!is_to_be_told(fact)) transaction.retract(fact);
  }
  for (const auto& [fact, because] : missing) {
    if (is_to_be_told(fact)) transaction.tell(fact, because, service_.presence());
  }
  if (transaction.steps.empty()) co_return;
  // Where it fails the presence has lapsed, and all is told anew once it is back.
  const Result<Revision> told = co_await commit(context_.board, context_.executor, std::move(transaction));
  if (!told) all_told_ = false;
  co_await sleep(context_.executor, put_right_pause);
}

}  // namespace pizarra::coordinator
