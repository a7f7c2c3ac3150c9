// The simulated cameras that a cell file describes.

#include <gtest/gtest.h>

#include "agents/launcher/agent_factory.hpp"

namespace pizarra::launcher {
namespace {

TEST(CellCamera, SeesTheSamePartOfTheWorldInLargerImages) {
  const Result<forms::CellDescription> cell = forms::read_cell("(cell c (world (camera (size 1280 960))))", "c.scm");
  ASSERT_TRUE(cell) << describe(cell.error());
  const Result<simulation::WorldConfig> world = world_config(*cell, 1);
  ASSERT_TRUE(world) << describe(world.error());
  const camera::StereoModel& model = world->camera.model;
  EXPECT_EQ(model.width, 1280);
  EXPECT_EQ(model.height, 960);
  EXPECT_DOUBLE_EQ(model.focal_px, 4 * camera::StereoModel().focal_px);
  EXPECT_DOUBLE_EQ(model.centre_x_px, 639.5);
  EXPECT_DOUBLE_EQ(model.centre_y_px, 479.5);
}

}  // namespace
}  // namespace pizarra::launcher
