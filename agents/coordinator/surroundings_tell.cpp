// What of the surroundings is told as facts.

#include <cmath>
#include <fmt/format.h>

#include "agents/coordinator/surroundings.hpp"
#include "agents/coordinator/telling.hpp"

namespace pizarra {

namespace {

// A mark that moved less is not told anew.
constexpr double told_again_mm = 1;

double rounded(double mm) { return std::round(mm * 10) / 10; }

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

}  // namespace pizarra
