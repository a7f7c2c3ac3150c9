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

Transaction own_binding(const std::string& name, const Contract& contract, LeaseId presence) {
  const std::string context = contract.context.empty() ? context_for(contract.kind) : contract.context;
  const Datum cell = "cell"_sym;
  Transaction binding;
  binding.tell(list("context"_sym, Datum::list({}), cell));
  binding.tell(list("context"_sym, list(cell), Datum::symbol(context)));
  binding.tell(list("bound"_sym, list(cell, Datum::symbol(context)), Datum::symbol(name), Datum::symbol(contract.kind),
                    Datum::symbol(name)),
               {}, presence);
  return binding;
}

}  // namespace pizarra::runtime
