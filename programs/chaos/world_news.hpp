#pragma once

// How the cubes truly lie, told where it changed: a replayed story shows it beside what the cell believes.
//
//   WorldNews news;
//   if (std::optional<std::string> sentence = news.of(world)) narrator.say(now, "world", *sentence);
//
// Told when the same was seen twice in a row, so that what moves is told once, where it comes to rest.

#include <optional>
#include <string>

#include "programs/story/world_state.hpp"

namespace pizarra::chaos {

class WorldNews {
 public:
  std::optional<std::string> of(const story::WorldState& world);

 private:
  story::WorldState told_;
  story::WorldState before_;
};

}  // namespace pizarra::chaos
