#pragma once

// Small domains with random problems, and an oracle that knows nothing of the planner's grounding or engines.

#include <cstdint>
#include <optional>
#include <string>

#include "agents/planner/task/problem.hpp"
#include "blackboard/time/random.hpp"

namespace pizarra::planner {

Datum form(std::string_view text);
// The facts of a text like "(on a b) (clear a)".
std::vector<Datum> facts_of(std::string_view text);

// The thesis' four operators over blocks b0, b1, ...
PlanningTask blocks_domain(std::size_t blocks);
// Random piles to begin with and, as goals, the `on` facts of other random piles.
PlanningTask random_blocks(std::size_t blocks, Random& random);
// Three towns, some roads that never change, two trucks, two parcels.
PlanningTask random_logistics(Random& random);
// Two rooms, a robot with two grippers, three balls.
PlanningTask random_gripper(Random& random);
// Two or three discs on three pegs in any legal order, wanted in any other: discs and pegs are places, and a disc may
// not be moved to where it is. Some goals cannot be.
PlanningTask random_hanoi(Random& random);
// Seven facts and eight operators of no meaning at all: many have no plan.
PlanningTask random_nonsense(Random& random);

// Operators of no meaning whose parameters have types with a common parent, with facts that must be absent, equalities
// and goals that something be absent.
PlanningTask random_conditions(Random& random);

// The fewest parallel steps to the goals, by breadth-first search over all sets of actions that do not interfere; none
// where no plan exists. For tasks with at most 64 facts.
std::optional<std::size_t> fewest_steps(const PlanningTask& task);

std::string show(const PlanningTask& task);

}  // namespace pizarra::planner
