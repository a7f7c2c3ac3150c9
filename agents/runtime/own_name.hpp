#pragma once

// The names under which agents are bound. An agent binds itself by what it is: (bound (cell CONTEXT) NAME KIND NAME),
// told with its presence. The agents of one context can serve in each other's place (roles.hpp). Who starts agents
// binds them by where they run: (bound (cell hosts HOST) NAME KIND NAME).
//
//   context_for("robot")                         // "arms"
//   Transaction binding = own_binding("vision-2", contract, presence);
//       // (context () cell), (context (cell) eyes), (bound (cell eyes) vision-2 vision vision-2)
//   binding = binding_in({"cell", "hosts", "arm-pc"}, {"vision", "vision-2"}, lease);

#include <string>
#include <string_view>

#include "agents/runtime/contract.hpp"
#include "agents/runtime/naming.hpp"

namespace pizarra::runtime {

// In the context `cell`. A kind that is not of ours has one called like itself.
std::string context_for(std::string_view kind);

// Binds the agent by its own name in this context, and makes the contexts down to it, which are durable and stay; the
// binding goes with the lease.
Transaction binding_in(const Path& context, const Reference& agent, LeaseId lease);
Transaction own_binding(const std::string& name, const Contract& contract, LeaseId presence);

}  // namespace pizarra::runtime
