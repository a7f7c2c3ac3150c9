// Photographs that a cell file names.

#include "agents/launcher/cell_pictures.hpp"

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "agents/launcher/agent_factory.hpp"
#include "tests/scratch.hpp"

namespace pizarra::launcher {
namespace {

std::string written(const std::string& name, cv::Size size, const cv::Scalar& colour) {
  EXPECT_TRUE(cv::imwrite(scratch_folder() + name, cv::Mat(size, CV_8UC3, colour)));
  return name;
}

// A cell file in the scratch folder, whose world has these sections.
Result<simulation::WorldConfig> world_with(const std::string& sections) {
  const Result<forms::CellDescription> cell =
      forms::read_cell(fmt::format("(cell c\n  (world\n    {}))", sections), scratch_folder() + "cell.scm");
  if (!cell) return fail(cell);
  return world_config(*cell, 1);
}

TEST(CellPictures, AreReadFromBesideTheCellFile) {
  written("wall.jpg", {64, 48}, {10, 120, 240});
  written("cloth.png", {20, 30}, {200, 100, 50});
  const Result<simulation::WorldConfig> world = world_with("(background \"wall.jpg\") (table-picture \"cloth.png\")");
  ASSERT_TRUE(world) << describe(world.error());
  EXPECT_EQ(world->background->width(), 64);
  EXPECT_EQ(world->background->height(), 48);
  EXPECT_NEAR(world->background->at(30, 20, 1).z(), 240, 4);
  EXPECT_EQ(world->table_picture->at(10, 10, 1), Eigen::Vector3f(200, 100, 50));
  const Result<simulation::WorldConfig> plain = world_with("(cube circle (at 450 0))");
  ASSERT_TRUE(plain) << describe(plain.error());
  EXPECT_EQ(plain->background, nullptr);
}

TEST(CellPictures, AreMadeSmallerWhereNoCameraShowsAllOfThem) {
  written("large.png", {4096, 1000}, {0, 0, 0});
  const Result<simulation::WorldConfig> world = world_with("(background \"large.png\")");
  ASSERT_TRUE(world) << describe(world.error());
  EXPECT_EQ(world->background->width(), 2048);
  EXPECT_EQ(world->background->height(), 500);
}

TEST(CellPictures, ThatCannotBeReadAreOneErrorWithItsPlace) {
  std::ofstream(scratch_folder() + "words.png") << "no image";
  std::ofstream(scratch_folder() + "nothing.png") << "";
  std::ofstream(scratch_folder() + "moving.gif") << "GIF89a";
  for (const char* name : {"missing.jpg", "words.png", "nothing.png", "moving.gif", "."}) {
    const Result<simulation::WorldConfig> world = world_with(fmt::format("(table-picture \"{}\")", name));
    ASSERT_FALSE(world) << name;
    EXPECT_EQ(world.error().symbol, "corrupt-frame");
    EXPECT_NE(world.error().sentence.find(scratch_folder()), std::string::npos) << world.error().sentence;
    EXPECT_NE(world.error().place.find("cell.scm:3:20\n"), std::string::npos) << world.error().place;
  }
}

}  // namespace
}  // namespace pizarra::launcher
