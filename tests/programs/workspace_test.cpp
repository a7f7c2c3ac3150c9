#include "programs/chaos/workspace.hpp"

#include <gtest/gtest.h>

namespace pizarra::chaos {
namespace {

story::WorldState::Cube cube_at(double x_mm, double y_mm) {
  story::WorldState::Cube cube;
  cube.x_mm = x_mm;
  cube.y_mm = y_mm;
  cube.z_mm = 30;
  return cube;
}

bool has(const story::WorldState::Cube& cube) {
  story::WorldState world;
  world.cubes["circle"] = cube;
  return !Workspace(simulation::WorldConfig()).within(world).cubes.at("circle").gone;
}

TEST(Workspace, HasWhatIsHidden) {
  story::WorldState::Cube cube = cube_at(450, 165);
  cube.visible = 1;
  EXPECT_TRUE(has(cube));
  cube.visible = 0;
  EXPECT_TRUE(has(cube));
}

// Cameras that stand 1330 mm before the arm show neither.
TEST(Workspace, HasWhatLiesBesideTheImages) {
  EXPECT_TRUE(has(cube_at(465, -281)));
  EXPECT_TRUE(has(cube_at(402, 327)));
}

TEST(Workspace, HasNotWhatTheArmDoesNotReach) {
  EXPECT_TRUE(has(cube_at(450, 0)));
  EXPECT_TRUE(has(cube_at(320, 0)));
  EXPECT_TRUE(has(cube_at(260, -180)));
  EXPECT_TRUE(has(cube_at(560, -100)));
  EXPECT_FALSE(has(cube_at(640, 0)));
}

TEST(Workspace, HasWhatStandsNearTheArm) { EXPECT_TRUE(has(cube_at(158, -158))); }

TEST(Workspace, HasNotWhatFellOffTheTable) {
  story::WorldState::Cube cube = cube_at(450, 0);
  cube.z_mm = -20;
  EXPECT_FALSE(has(cube));
}

TEST(Workspace, WhatIsGoneStaysGoneAndWhatIsHeldIsThere) {
  story::WorldState::Cube gone = cube_at(450, 0);
  gone.gone = true;
  EXPECT_FALSE(has(gone));
  story::WorldState::Cube held = cube_at(450, 600);
  held.held = true;
  EXPECT_TRUE(has(held));
}

}  // namespace
}  // namespace pizarra::chaos
