#include "agents/coordinator/geometry/seen_places.hpp"

namespace pizarra::coordinator {

namespace {

// More than what is measured wavers.
constexpr double moved_mm = 20;
// A single look may mistake one object for another.
constexpr std::uint64_t looks_of_rest = 5;

}  // namespace

SeenPlaces::SeenPlaces(const Sightings& sightings, std::string but) : but_(std::move(but)) {
  for (const auto& [name, sighting] : sightings.all()) places_mm_.emplace(name, sighting.place_mm);
}

std::optional<std::string> SeenPlaces::moved(const Sightings& sightings) const {
  for (const auto& [name, sighting] : sightings.all()) {
    const bool lies_still = sightings.recent(name, 1) && sightings.still_looks(name) >= looks_of_rest;
    if (name == but_ || !lies_still) continue;
    const auto before = places_mm_.find(name);
    if (before == places_mm_.end() || (sighting.place_mm - before->second).norm() > moved_mm) return name;
  }
  return std::nullopt;
}

}  // namespace pizarra::coordinator
