#include "agents/planner/graphplan/nogoods.hpp"

#include <algorithm>
#include <cassert>

namespace pizarra::planner {

std::uint32_t Nogoods::child_of(std::uint32_t node, std::size_t fact) {
  for (std::uint32_t child = nodes_[node].first_child; child != none; child = nodes_[child].next_sibling) {
    if (nodes_[child].fact == fact) return child;
  }
  const auto child = static_cast<std::uint32_t>(nodes_.size());
  nodes_.push_back(Node{.fact = static_cast<std::uint32_t>(fact), .parent = node});
  nodes_[child].next_sibling = nodes_[node].first_child;
  nodes_[node].first_child = child;
  return child;
}

void Nogoods::add(std::vector<std::size_t> facts, std::size_t level) {
  assert(!facts.empty() && std::ranges::is_sorted(facts));
  std::uint32_t node = 0;
  for (const std::size_t fact : facts) node = child_of(node, fact);
  if (nodes_[node].entry == none) {
    nodes_[node].entry = static_cast<std::uint32_t>(entries_.size());
    entries_.push_back({.facts = std::move(facts), .level = 0, .node = node});
  }
  raise(nodes_[node].entry, level);
}

void Nogoods::raise(std::size_t entry, std::size_t level) {
  entries_[entry].level = std::max(entries_[entry].level, level);
  auto node = static_cast<std::uint32_t>(entries_[entry].node);
  for (; node != none; node = nodes_[node].parent) {
    nodes_[node].max_level = std::max(nodes_[node].max_level, static_cast<std::uint32_t>(level));
  }
}

std::optional<std::size_t> Nogoods::find(const Bits& goals, std::size_t level) const {
  return find_below(0, goals, level);
}

std::optional<std::size_t> Nogoods::find_below(std::uint32_t node, const Bits& goals, std::size_t level) const {
  for (std::uint32_t child = nodes_[node].first_child; child != none; child = nodes_[child].next_sibling) {
    const Node& here = nodes_[child];
    if (here.max_level < level || !goals.test(here.fact)) continue;
    if (here.entry != none && entries_[here.entry].level >= level) return here.entry;
    const std::optional<std::size_t> below = find_below(child, goals, level);
    if (below) return below;
  }
  return std::nullopt;
}

}  // namespace pizarra::planner
