#pragma once

// The name under which an agent binds itself: (bound (cell CONTEXT) NAME KIND NAME), told with its presence. The agents
// of one context can serve in each other's place (roles.hpp).
//
//   context_for("robot")                         // "arms"
//   Transaction binding = own_binding("vision-2", contract, presence);
//       // (context () cell), (context (cell) eyes), (bound (cell eyes) vision-2 vision vision-2)

#include <string>
#include <string_view>

#include "agents/runtime/contract.hpp"
#include "blackboard/board.hpp"

namespace pizarra::runtime {

// In the context `cell`. A kind that is not of ours has one called like itself.
std::string context_for(std::string_view kind);

// Contexts are durable and stay; the binding goes with the lease.
Transaction own_binding(const std::string& name, const Contract& contract, LeaseId presence);

}  // namespace pizarra::runtime
