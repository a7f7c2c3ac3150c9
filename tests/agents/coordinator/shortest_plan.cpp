#include "tests/agents/coordinator/shortest_plan.hpp"

#include <algorithm>
#include <deque>
#include <map>

namespace pizarra::coordinator {

namespace {

std::vector<GroundOperation> ground_operations(const TaskDomain& domain, const Datum& types) {
  std::vector<GroundOperation> operations;
  for (const forms::Operator& known : domain.domain().operators) {
    std::vector<std::vector<Datum>> names{{Datum::symbol(known.name)}};
    for (std::size_t i = 0; i < known.params.size(); ++i) {
      std::vector<std::vector<Datum>> longer;
      for (const std::vector<Datum>& name : names) {
        for (const Datum& type : types.items().subspan(1)) {
          if (type[1].text() != known.params[i].type) continue;
          longer.push_back(name);
          longer.back().push_back(type[0]);
        }
      }
      names = std::move(longer);
    }
    for (const std::vector<Datum>& name : names) operations.push_back(domain.ground(Datum::list(name)).value());
  }
  return operations;
}

}  // namespace

std::optional<std::vector<Datum>> shortest_plan(const TaskDomain& domain, const Datum& types, const Facts& initials,
                                                const Facts& goals) {
  const std::vector<GroundOperation> operations = ground_operations(domain, types);
  std::map<Facts, std::vector<Datum>> reached{{initials, {}}};
  std::deque<Facts> open{initials};
  while (!open.empty()) {
    const Facts state = open.front();
    open.pop_front();
    const std::vector<Datum> plan = reached[state];
    if (std::ranges::includes(state, goals)) return plan;
    for (const GroundOperation& operation : operations) {
      const auto holds = [&](const Datum& fact) { return state.contains(fact); };
      if (!std::ranges::all_of(operation.preconditions, holds)) continue;
      Facts next = state;
      for (const Datum& fact : operation.deletes) next.erase(fact);
      next.insert(operation.adds.begin(), operation.adds.end());
      if (reached.contains(next)) continue;
      reached[next] = plan;
      reached[next].push_back(operation.name);
      open.push_back(next);
    }
  }
  return std::nullopt;
}

}  // namespace pizarra::coordinator
