#pragma once

// The fewest faults with which a run that failed still fails.
//
//   const std::vector<std::size_t> faults = shrink(story);       // indices, as PlayOptions::faults has them

#include <string>
#include <vector>

#include "programs/chaos/chaos_run.hpp"

namespace pizarra::chaos {

inline constexpr int most_shrinking_runs = 40;

// The fewest faults of the story that fail as it does, by leaving out one half after another, then one after another.
// Plays most_shrinking_runs at most.
std::vector<std::size_t> shrink(const ChaosStory& story, const std::string& plant = {});

}  // namespace pizarra::chaos
