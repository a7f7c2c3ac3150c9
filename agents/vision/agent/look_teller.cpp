#include "agents/vision/agent/look_teller.hpp"

#include <algorithm>

#include "agents/vision/agent/reply_text.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::vision {

Task<void> LookTeller::tell(std::uint64_t frame, const std::vector<TrackSighting>& sightings) {
  if (std::exchange(beginning_, facts_.beginnings()) != facts_.beginnings()) states_.clear();
  Transaction transaction;
  // What is followed no more is not seen either.
  std::erase_if(states_, [&](const auto& told) {
    const bool followed = std::ranges::find(sightings, told.first, &TrackSighting::name) != sightings.end();
    if (!followed) facts_.retract(transaction, list("tracked"_sym, told.first, "?"_sym, "?"_sym, "?"_sym));
    return !followed;
  });
  std::vector<Datum> facts;
  for (const TrackSighting& sighting : sightings) {
    const std::string_view state = track_state(sighting);
    std::string& told = states_[sighting.name];
    if (told == state) continue;
    told = state;
    facts.push_back(
        list("tracked"_sym, sighting.name, Datum::symbol(state), frame, rounded(sighting.confidence, 1000)));
  }
  facts.push_back(look_fact(frame, sightings));
  facts_.add(transaction, facts);
  co_await facts_.transact(std::move(transaction));
}

Task<void> LookTeller::unsay() {
  states_.clear();
  Transaction transaction;
  facts_.retract_all(transaction, "look"_sym, 3);
  facts_.retract_all(transaction, "tracked"_sym, 4);
  co_await facts_.transact(std::move(transaction));
}

}  // namespace pizarra::vision
