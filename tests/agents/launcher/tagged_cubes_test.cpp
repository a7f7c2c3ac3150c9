// Cell files whose cubes wear tags.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "agents/launcher/agent_factory.hpp"
#include "agents/vision/marks/tag_detection.hpp"

namespace pizarra::launcher {
namespace {

Result<forms::CellDescription> cell_with(std::string_view family, int number) {
  const std::string text = fmt::format("(cell c (world (cube lid (mark {} {}) (at 450 0))))", family, number);
  return forms::read_cell(text, "c.scm");
}

TEST(TaggedCubes, ACellMayNameEveryTagWithADarkSquareThatTheEyesReadAndNoOther) {
  for (const vision::TagFamily& family : vision::tag_families()) {
    if (family.is_wide()) {
      EXPECT_FALSE(cell_with(family.name, 0)) << family.name;
      continue;
    }
    const int tags = vision::tags_of(family);
    const Result<forms::CellDescription> cell = cell_with(family.name, tags - 1);
    ASSERT_TRUE(cell) << family.name << ": " << cell.error().sentence;
    const Result<simulation::WorldConfig> world = world_config(*cell, 1);
    ASSERT_TRUE(world) << family.name;
    EXPECT_EQ(simulation::face_mark_name(world->cubes.front().mark), fmt::format("{}-{}", family.name, tags - 1));
    EXPECT_FALSE(cell_with(family.name, tags)) << family.name;
  }
}

}  // namespace
}  // namespace pizarra::launcher
