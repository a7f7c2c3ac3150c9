#pragma once

// In how many runs the observers find a planted fault (plants.hpp).
//
//   const PlantSearch search = find_plant({.cell = cell, .runs = 30, .plant = "plan-not-kept"});

#include "programs/chaos/swarm.hpp"

namespace pizarra::chaos {

struct PlantSearch {
  std::uint64_t found_by = 0;  // so many runs; 0: none found it
  bool whole = true;           // not interrupted
};
// Runs until one fails that does not fail without the planted fault.
PlantSearch find_plant(const SwarmOptions& options);

}  // namespace pizarra::chaos
