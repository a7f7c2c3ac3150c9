#include "programs/chaos/world_news.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace pizarra::chaos {

namespace {

using Cube = story::WorldState::Cube;

constexpr double moved_mm = 10;

bool is_alike(const Cube& a, const Cube& b) {
  const bool same_state = a.gone == b.gone && a.held == b.held && a.on == b.on && a.loose == b.loose;
  const double way_mm = std::hypot(a.x_mm - b.x_mm, a.y_mm - b.y_mm, a.z_mm - b.z_mm);
  // What is held goes where the arm goes.
  return same_state && (way_mm < moved_mm || a.held || a.gone);
}

bool are_alike(const story::WorldState& a, const story::WorldState& b) {
  return std::ranges::equal(a.cubes, b.cubes, [](const auto& x, const auto& y) {
    return x.first == y.first && is_alike(x.second, y.second);
  });
}

std::string text_of(const std::string& name, const Cube& cube) {
  if (cube.gone) return name + " is gone";
  if (cube.held) return name + " is held";
  if (!cube.on.empty()) return fmt::format("{} on {}", name, cube.on);
  const std::string at = fmt::format("{:.0f} {:.0f} {:.0f}", cube.x_mm, cube.y_mm, cube.z_mm);
  const std::string seen = cube.visible < 1 ? fmt::format(", {:.0f} % of its mark to be seen", 100 * cube.visible) : "";
  return fmt::format("{}{} at {}{}", name, cube.loose ? " loose" : "", at, seen);
}

}  // namespace

std::optional<std::string> WorldNews::of(const story::WorldState& world) {
  const bool at_rest = are_alike(world, before_);
  before_ = world;
  if (!at_rest || are_alike(world, told_)) return std::nullopt;
  told_ = world;
  std::string text;
  for (const auto& [name, cube] : world.cubes) text += (text.empty() ? "" : ", ") + text_of(name, cube);
  return text;
}

}  // namespace pizarra::chaos
