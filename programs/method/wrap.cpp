#include "programs/method/wrap.hpp"

#include <algorithm>

namespace pizarra::method {

namespace {

AbstractionIndex index_of(const Wrapped& list, const std::set<std::string>& offered) {
  AbstractionIndex index{.wrapped = list.name, .operations = 0, .functions = list.functions, .value = 0};
  // A list that names no operations means all that are offered.
  index.operations = list.operations.empty() ? offered.size() : 0;
  for (const std::string& operation : list.operations) index.operations += offered.contains(operation) ? 1 : 0;
  if (index.functions > 0) {
    index.value = static_cast<double>(index.operations) / static_cast<double>(index.functions);
  }
  return index;
}

std::set<std::string> parts_of(const AgentSeen& agent, const Component* known) {
  std::set<std::string> parts;
  if (known != nullptr) parts = known->does;
  if (!names_in(agent.contract, "offers").empty()) parts.insert("abstraction");
  if (!names_in(agent.contract, "monitors").empty()) parts.insert("monitoring");
  if (!names_in(agent.contract, "configures").empty()) parts.insert("configuration");
  return parts;
}

}  // namespace

std::vector<Wrapping> wrap(const Traffic& traffic, const std::vector<Wrapped>& lists,
                           const std::map<std::string, Component>& kinds) {
  std::vector<Wrapping> wrappings;
  for (const auto& [name, agent] : traffic.agents) {
    const auto known = kinds.find(agent.kind);
    const std::set<std::string> offered = names_in(agent.contract, "offers");
    Wrapping wrapping{.component = name, .offered = offered.size(), .indices = {}, .parts = {}};
    wrapping.parts = parts_of(agent, known == kinds.end() ? nullptr : &known->second);
    for (const Wrapped& list : lists) {
      if (list.kind == agent.kind) wrapping.indices.push_back(index_of(list, offered));
    }
    wrappings.push_back(std::move(wrapping));
  }
  return wrappings;
}

}  // namespace pizarra::method
