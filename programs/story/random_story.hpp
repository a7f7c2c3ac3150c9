#pragma once

// A story drawn from a seed: how the cubes stand, what is wanted, and one disturbance at some time.
//
//   RandomStory story = random_story(cell, Random(seed));

#include "blackboard/time/random.hpp"
#include "lisp/forms/domain.hpp"
#include "lisp/forms/scenario_file.hpp"

namespace pizarra::story {

// The cell with its cubes piled up otherwise, and a scenario with a goal over them. The disturbance is a hand that
// pushes, places, stacks, steals, removes or knocks, or an agent that is killed and comes back.
struct RandomStory {
  forms::CellDescription cell;
  forms::Scenario scenario;
};

// Whether stories can be drawn for the cell: two cubes or more, a row with room for two piles, and a domain with (on A
// B) and (on-table A). Failure: bad-cell.
Result<void> check_random_cell(const forms::CellDescription& cell, const forms::Domain& domain);

// The cell passed check_random_cell().
RandomStory random_story(forms::CellDescription cell, Random random);

// The story that belongs to a run's seed.
inline RandomStory random_story_of_seed(forms::CellDescription cell, std::uint64_t seed) {
  return random_story(std::move(cell), Random(seed).split("story"));
}

}  // namespace pizarra::story
