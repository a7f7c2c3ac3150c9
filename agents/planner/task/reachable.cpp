#include "agents/planner/task/reachable.hpp"

#include <algorithm>
#include <utility>

namespace pizarra::planner {

std::vector<char> drop_unreachable(std::vector<GroundAction>& actions, const std::vector<char>& initially) {
  std::vector<char> reachable(initially.size(), 0);
  std::vector<std::size_t> open;
  const auto reach = [&](std::size_t fact) {
    if (std::exchange(reachable[fact], 1) == 0) open.push_back(fact);
  };
  std::vector<std::vector<std::size_t>> needed_by(initially.size());
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    missing.push_back(actions[i].preconditions.size());
    for (const std::size_t fact : actions[i].preconditions) needed_by[fact].push_back(i);
    if (missing.back() == 0) std::ranges::for_each(actions[i].adds, reach);
  }
  for (std::size_t fact = 0; fact < initially.size(); ++fact) {
    if (initially[fact] != 0) reach(fact);
  }
  while (!open.empty()) {
    const std::size_t fact = open.back();
    open.pop_back();
    for (const std::size_t i : needed_by[fact]) {
      if (--missing[i] == 0) std::ranges::for_each(actions[i].adds, reach);
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (missing[i] != 0) continue;
    if (kept != i) actions[kept] = std::move(actions[i]);
    ++kept;
  }
  actions.resize(kept);
  return reachable;
}

}  // namespace pizarra::planner
