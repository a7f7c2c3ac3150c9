#include "agents/vision/agent/fact_teller.hpp"

#include <algorithm>

#include "agents/vision/agent/reply_text.hpp"
#include "agents/vision/database/told_by.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::vision {

void FactTeller::begin_anew() {
  // What was told under another presence went with it.
  if (lost()) {
    told_tracks_.clear();
    no_tags_told_ = false;
  }
  told_under_ = service_->presence();
}

Task<void> FactTeller::transact(Transaction transaction) {
  if (transaction.steps.empty()) co_return;
  const Result<Revision> told = co_await context_.board.transact(std::move(transaction));
  if (!told) told_under_ = 0;
}

void FactTeller::add(Transaction& transaction, const std::vector<Datum>& facts) const {
  for (const Datum& fact : facts) transaction.tell(told_by(context_.name, fact), {}, service_->presence());
}

void FactTeller::retract_all(Transaction& transaction, Datum relation, std::size_t arguments) const {
  transaction.retract(any_told_by(context_.name, std::move(relation), arguments));
}

Task<void> FactTeller::tell(std::vector<Datum> facts) {
  Transaction transaction;
  add(transaction, facts);
  co_await transact(std::move(transaction));
}

Task<void> FactTeller::tell_held(std::vector<Datum> facts) {
  Transaction transaction;
  for (const Datum& fact : told_held_) {
    const bool stays = std::ranges::find(facts, fact) != facts.end();
    if (!stays) transaction.retract(told_by(context_.name, fact));
  }
  add(transaction, facts);
  told_held_ = std::move(facts);
  co_await transact(std::move(transaction));
}

Task<void> FactTeller::tell_objects(std::vector<Datum> facts) {
  Transaction transaction;
  retract_all(transaction, "to-accept"_sym, 2);
  retract_all(transaction, "look-alike"_sym, 4);
  retract_all(transaction, "objects-damaged"_sym, 3);
  retract_all(transaction, "searched-in"_sym, 5);
  retract_all(transaction, "looked-at-most"_sym, 2);
  add(transaction, facts);
  co_await transact(std::move(transaction));
}

Task<void> FactTeller::tell_look(std::uint64_t frame, const std::vector<TrackSighting>& sightings) {
  Transaction transaction;
  // What is followed no more is not seen either.
  std::erase_if(told_tracks_, [&](const auto& told) {
    const bool followed = std::ranges::find(sightings, told.first, &TrackSighting::name) != sightings.end();
    if (!followed)
      transaction.retract(told_by(context_.name, list("tracked"_sym, told.first, "?"_sym, "?"_sym, "?"_sym)));
    return !followed;
  });
  std::vector<Datum> facts;
  for (const TrackSighting& sighting : sightings) {
    const std::string_view state = track_state(sighting);
    std::string& told = told_tracks_[sighting.name];
    if (told == state) continue;
    told = state;
    facts.push_back(
        list("tracked"_sym, sighting.name, Datum::symbol(state), frame, rounded(sighting.confidence, 1000)));
  }
  facts.push_back(look_fact(frame, sightings));
  add(transaction, facts);
  co_await transact(std::move(transaction));
}

Task<void> FactTeller::tell_tags(std::uint64_t frame, Time captured, std::vector<FoundMark> seen) {
  if (seen.empty() && no_tags_told_) co_return;
  no_tags_told_ = seen.empty();
  std::vector<Datum> facts;
  facts.push_back(tags_fact(frame, captured, seen));
  co_await tell(std::move(facts));
}

Task<void> FactTeller::follow_found(Renames renames, const LearnedObjects& objects) {
  const Datum any = any_told_by(context_.name, "found"_sym, 7);
  const Result<std::vector<Fact>> standing = co_await context_.board.facts(any);
  if (!standing) co_return;
  Transaction transaction;
  std::vector<Datum> renamed;
  for (const Fact& fact : *standing) {
    const Datum found = as_said(fact.datum);
    std::vector<Datum> items(found.items().begin(), found.items().end());
    bool gone = false;
    for (Datum* name : {&items[1], &items[4]}) {
      // Where nothing came near there is no second.
      if (name->text().empty()) continue;
      const LearnedObject* object = objects.find(name_now(renames, std::string(name->text())));
      gone = gone || object == nullptr;
      if (object != nullptr) *name = to_datum(object->name);
    }
    Datum now = Datum::list(std::move(items));
    if (!gone && now == found) continue;
    transaction.retract(fact.datum);
    if (!gone) renamed.push_back(std::move(now));
  }
  add(transaction, renamed);
  co_await transact(std::move(transaction));
}

Task<void> FactTeller::tell_streams(std::vector<Datum> facts) {
  Transaction transaction;
  for (const Datum& fact : facts) transaction.tell(fact, {}, service_->presence());
  co_await transact(std::move(transaction));
}

Task<void> FactTeller::unsay() {
  told_tracks_.clear();
  Transaction transaction;
  retract_all(transaction, "look"_sym, 3);
  retract_all(transaction, "tracked"_sym, 4);
  co_await transact(std::move(transaction));
}

Task<void> FactTeller::unsay_tags() {
  no_tags_told_ = false;
  Transaction transaction;
  retract_all(transaction, "tags-seen"_sym, 3);
  co_await transact(std::move(transaction));
}

}  // namespace pizarra::vision
