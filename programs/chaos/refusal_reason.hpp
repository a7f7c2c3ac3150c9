#pragma once

// Whether the world confirms the reason for which a goal was refused.
//
//   const std::optional<std::string> denied = denied_reason(failure, world, had);    // none: it confirms it
//
// That no plan exists is judged elsewhere (verdict.hpp). A right outcome with a wrong reason tells the person at the
// cell what is not so, and sends them to look for a cube that lies before them.

#include <optional>
#include <string>

#include "lisp/result.hpp"
#include "programs/story/world_state.hpp"

namespace pizarra::chaos {

// `world`: as it is. `had`: the same, and what nothing in the cell can have is gone (workspace.hpp). No plan exists
// from there.
std::optional<std::string> denied_reason(const Failure& told, const story::WorldState& world,
                                         const story::WorldState& had);

}  // namespace pizarra::chaos
