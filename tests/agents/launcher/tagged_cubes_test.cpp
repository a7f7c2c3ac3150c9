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

TEST(TaggedCubes, FacesMayHaveMarksOfTheirOwn) {
  const Result<forms::CellDescription> cell = forms::read_cell(
      "(cell c (world (cube lid (mark apriltag-36h11 1) (faces (top cross) (left apriltag-36h11 2)) (at 450 0))))",
      "c.scm");
  ASSERT_TRUE(cell) << describe(cell.error());
  const Result<simulation::WorldConfig> world = world_config(*cell, 1);
  ASSERT_TRUE(world) << describe(world.error());
  std::vector<std::string> names;
  for (const std::optional<simulation::FaceMark>& mark : world->cubes.front().marks()) {
    names.push_back(simulation::face_mark_name(mark.value()));
  }
  const std::string usual = "apriltag-36h11-1";
  EXPECT_EQ(names, (std::vector<std::string>{usual, usual, usual, "apriltag-36h11-2", "cross", usual}))
      << "front, back, right, left, top, bottom";
}

}  // namespace
}  // namespace pizarra::launcher
