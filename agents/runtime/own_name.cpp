#include "agents/runtime/own_name.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace pizarra::runtime {

std::string context_for(std::string_view kind) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> known{{{"robot", "arms"},
                                                                                {"vision", "eyes"},
                                                                                {"pan-tilt", "heads"},
                                                                                {"planner", "planners"},
                                                                                {"coordinator", "coordinators"},
                                                                                {"person", "people"}}};
  const auto found = std::ranges::find(known, kind, &std::pair<std::string_view, std::string_view>::first);
  return std::string(found == known.end() ? kind : found->second);
}

Transaction binding_in(const Path& context, const Reference& agent, LeaseId lease) {
  Transaction binding;
  std::vector<Datum> above;
  for (const std::string& name : context) {
    binding.tell(list("context"_sym, Datum::list(above), Datum::symbol(name)));
    above.push_back(Datum::symbol(name));
  }
  binding.tell(list("bound"_sym, Datum::list(above), Datum::symbol(agent.agent), Datum::symbol(agent.kind),
                    Datum::symbol(agent.agent)),
               {}, lease);
  return binding;
}

Transaction own_binding(const std::string& name, const Contract& contract, LeaseId presence) {
  const std::string context = contract.context.empty() ? context_for(contract.kind) : contract.context;
  return binding_in({"cell", context}, {contract.kind, name}, presence);
}

}  // namespace pizarra::runtime
