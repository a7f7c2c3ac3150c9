#include "programs/chaos/refusal_reason.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/coordinator/perceive/missing_objects.hpp"

namespace pizarra::chaos {

namespace {

using Cubes = std::map<std::string, story::WorldState::Cube>;

// One that the world never had is missing as well.
std::optional<std::string> denied_missing(const Failure& told, const Cubes& had) {
  for (const std::string& name : coordinator::names_of_missing(told)) {
    const auto found = had.find(std::string(story::in_small_letters(Datum::symbol(name)).text()));
    if (found == had.end() || found->second.gone) continue;
    const story::WorldState::Cube& cube = found->second;
    return fmt::format("{} is there, at ({:.0f} {:.0f} {:.0f}), {:.0f} % of its mark in sight", name, cube.x_mm,
                       cube.y_mm, cube.z_mm, 100 * cube.visible);
  }
  return std::nullopt;
}

bool lies_out_of_reach(const Cubes& world, const Cubes& had) {
  return std::ranges::any_of(world, [&](const auto& known) {
    const auto& [name, cube] = known;
    return !cube.gone && had.at(name).gone;
  });
}

}  // namespace

std::optional<std::string> denied_reason(const Failure& told, const story::WorldState& world,
                                         const story::WorldState& had) {
  if (told.symbol == "no-plan") return std::nullopt;
  if (told.symbol == "missing-object") return denied_missing(told, had.cubes);
  if (told.symbol == "unreachable" && lies_out_of_reach(world.cubes, had.cubes)) return std::nullopt;
  // A hold-up ends long before it is a reason. A failed operation proves nothing.
  return fmt::format("nothing in the world is {}", told.symbol);
}

}  // namespace pizarra::chaos
