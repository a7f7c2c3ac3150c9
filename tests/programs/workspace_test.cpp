#include "programs/chaos/workspace.hpp"

#include <gtest/gtest.h>

namespace pizarra::chaos {
namespace {

simulation::WorldConfig before_the_arm() {
  simulation::WorldConfig config;
  config.camera.pose.at_mm = {1330, 0, 200};
  return config;
}

story::WorldState::Cube cube_at(double x_mm, double y_mm) {
  story::WorldState::Cube cube;
  cube.x_mm = x_mm;
  cube.y_mm = y_mm;
  cube.z_mm = 30;
  return cube;
}

bool has(const simulation::WorldConfig& config, const story::WorldState::Cube& cube) {
  story::WorldState world;
  world.cubes["circle"] = cube;
  return !Workspace(config).within(world).cubes.at("circle").gone;
}

TEST(Workspace, HasWhatLiesBeforeBothCamerasAlsoWhereItIsHidden) {
  story::WorldState::Cube cube = cube_at(450, 165);
  cube.visible = 1;
  EXPECT_TRUE(has(before_the_arm(), cube));
  cube.visible = 0;
  EXPECT_TRUE(has(before_the_arm(), cube));
}

TEST(Workspace, HasNotWhatLiesBesideTheImages) {
  EXPECT_FALSE(has(before_the_arm(), cube_at(465, -281)));
  EXPECT_FALSE(has(before_the_arm(), cube_at(402, 327)));
}

TEST(Workspace, HasNotWhatTheArmDoesNotReach) {
  simulation::WorldConfig config = before_the_arm();
  config.camera.pose.at_mm = {2000, 0, 200};
  EXPECT_TRUE(has(config, cube_at(450, 0)));
  EXPECT_TRUE(has(config, cube_at(320, 0)));
  EXPECT_TRUE(has(config, cube_at(260, -180)));
  EXPECT_TRUE(has(config, cube_at(560, -100)));
  EXPECT_FALSE(has(config, cube_at(640, 0)));
}

TEST(Workspace, HasWhatStandsNearTheArm) { EXPECT_TRUE(has(before_the_arm(), cube_at(158, -158))); }

TEST(Workspace, SeesEverywhereWhereAHeadTurnsTheCameras) {
  simulation::WorldConfig config = before_the_arm();
  config.camera.head = "ptu";
  EXPECT_TRUE(has(config, cube_at(420, -281)));
}

TEST(Workspace, WhatIsGoneStaysGoneAndWhatIsHeldIsThere) {
  story::WorldState::Cube gone = cube_at(450, 0);
  gone.gone = true;
  EXPECT_FALSE(has(before_the_arm(), gone));
  story::WorldState::Cube held = cube_at(450, 600);
  held.held = true;
  EXPECT_TRUE(has(before_the_arm(), held));
}

}  // namespace
}  // namespace pizarra::chaos
