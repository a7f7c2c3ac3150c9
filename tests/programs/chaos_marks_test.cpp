// Which tags and bodies the cells of runs under faults have.

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <gtest/gtest.h>
#include <opencv2/core/eigen.hpp>
#include <set>

#include "agents/launcher/agent_factory.hpp"
#include "agents/vision/agent/body_form.hpp"
#include "drivers/simulation/render/scene.hpp"
#include "programs/chaos/draw_cubes.hpp"
#include "programs/chaos/draw_marks.hpp"
#include "programs/chaos/draw_story.hpp"
#include "tests/programs/four_cubes.hpp"

namespace pizarra::chaos {
namespace {

using forms::CellDescription;

constexpr std::uint64_t stories = 300;

CellDescription cell_of(std::uint64_t seed) { return draw_story(programs::four_cubes(), seed, {}).cell; }

std::vector<CellDescription> cells_that(const std::function<bool(const CellDescription&)>& fit) {
  std::vector<CellDescription> cells;
  for (std::uint64_t seed = 1; seed <= stories; ++seed) {
    CellDescription cell = cell_of(seed);
    if (fit(cell)) cells.push_back(std::move(cell));
  }
  return cells;
}

TEST(ChaosMarks, SomeCellsHaveTagsAndSomeHaveBodiesAndMostHaveNeither) {
  for (const auto& fit : {has_tagged_cubes, has_bodies}) {
    EXPECT_GT(cells_that(fit).size(), 15U);
    EXPECT_LT(cells_that(fit).size(), 75U);
  }
  EXPECT_GT(cells_that([](const auto& cell) { return has_bodies(cell) && has_tagged_cubes(cell); }).size(), 0U);
  EXPECT_GT(cells_that([](const auto& cell) { return has_bodies(cell) && !has_tagged_cubes(cell); }).size(), 0U);
}

TEST(ChaosMarks, NoTagStandsTwiceInACellAndTheEyesKnowEachAsLargeAsItIs) {
  for (const CellDescription& cell : cells_that([](const auto& each) { return !each.tagged.empty(); })) {
    constexpr std::size_t most_known = 31;
    EXPECT_LE(cell.tagged.size(), most_known);
    std::set<std::pair<std::string, int>> tags;
    for (const forms::CellTagged& tagged : cell.tagged) {
      EXPECT_TRUE(tags.emplace(tagged.family, tagged.number).second) << tagged.name;
      EXPECT_EQ(tagged.side_mm, simulation::tag_part_of_edge * cell.cube_mm);
    }
    std::set<std::string> names;
    for (const forms::CubePlacement& cube : cell.cubes) EXPECT_TRUE(names.insert(cube.name).second) << cube.name;
    EXPECT_TRUE(launcher::world_config(cell, 1));
  }
}

TEST(ChaosMarks, CellsWithTagsHaveLargerImagesAndFewCubes) {
  for (const CellDescription& cell : cells_that([](const auto& each) { return !each.tagged.empty(); })) {
    EXPECT_EQ(cell.image.width_px, 640);
    EXPECT_FALSE(has_many_cubes(cell));
  }
}

// Right, down and into it, as one sees the cube that stands unturned before the camera.
Eigen::Vector3d on_body_axes(const Eigen::Vector3d& in_world) { return {in_world.y(), -in_world.z(), -in_world.x()}; }

const simulation::TagCells* cells_painted(const simulation::Scene& scene, int id) {
  for (const simulation::Solid& solid : scene.solids) {
    for (const simulation::Face& face : solid.faces) {
      for (const simulation::Decal& decal : face.decals) {
        if (decal.id == id && decal.cells) return &*decal.cells;
      }
    }
  }
  return nullptr;
}

// The body's mark whose tag the cube bears there.
const vision::MarkOnBody& mark_with(const CellDescription& cell, const vision::Body& body, const std::string& tag) {
  const auto is_it = [&](const forms::CellTagged& tagged) {
    return tagged.family + "-" + std::to_string(tagged.number) == tag;
  };
  return *body.mark(std::ranges::find_if(cell.tagged, is_it)->name);
}

TEST(ChaosMarks, EachTagOfABodyStandsWhereTheEyesAreToldThatItDoes) {
  const CellDescription cell = cells_that(has_bodies).front();
  const forms::CellBody& told = cell.bodies.front();
  const vision::Body body = vision::body_from(told.marks, told.name).value();
  const simulation::WorldConfig config = launcher::world_config(cell, 1).value();
  const auto cube = std::ranges::find(config.cubes, told.name, &simulation::CubeConfig::name);
  const double edge_mm = cell.cube_mm;
  simulation::Snapshot snapshot;
  snapshot.cubes.push_back(
      {Eigen::Isometry3d::Identity(), cube->marks(), true, {false, Eigen::Vector3d::Constant(edge_mm)}});
  const simulation::Scene scene = moving_scene(config, snapshot);
  for (int side = 0; side < 6; ++side) {
    const simulation::TagCells* painted = cells_painted(scene, simulation::mark_id(0, side));
    ASSERT_NE(painted, nullptr) << side;
    const auto& mark = mark_with(cell, body, face_mark_name(*cube->marks()[static_cast<std::size_t>(side)]));
    const Eigen::Vector3d middle =
        painted->corner_mm + painted->print->side / 2.0 * (painted->right_mm + painted->down_mm);
    Eigen::Matrix3d turn;
    cv::cv2eigen(mark.turn, turn);
    Eigen::Vector3d place;
    cv::cv2eigen(mark.place_mm, place);
    EXPECT_LT((on_body_axes(middle) - place).norm(), 0.5) << mark.name;
    EXPECT_LT((on_body_axes(painted->right_mm.normalized()) - turn.col(0)).norm(), 1e-6) << mark.name;
    EXPECT_LT((on_body_axes(painted->down_mm.normalized()) - turn.col(1)).norm(), 1e-6) << mark.name;
  }
}

TEST(ChaosMarks, SaysWhichTagEachCubeWears) {
  for (const CellDescription& cell : cells_that(has_tagged_cubes)) {
    const std::vector<std::string> lines = describe_marks(cell);
    EXPECT_EQ(lines.size(), cell.tagged.size());
    EXPECT_NE(lines.front().find(" wears "), std::string::npos);
  }
}

CellDescription cell_with_an_own_tag() {
  CellDescription own = programs::four_cubes();
  own.cubes.front().mark = "aruco-4x4-50-3";
  own.tagged = {{"circle", "aruco-4x4-50", 3, 36}};
  return own;
}

TEST(ChaosMarks, GivesACellWithTagsOfItsOwnNoOthers) {
  const CellDescription own = cell_with_an_own_tag();
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_EQ(draw_story(own, seed, {}).cell.tagged.size(), 1U);
  }
}

TEST(ChaosMarks, ACellWithTagsOfItsOwnHasLargerImagesToo) {
  const CellDescription own = cell_with_an_own_tag();
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_EQ(draw_story(own, seed, {}).cell.image.width_px, 640) << seed;
  }
}

TEST(ChaosMarks, TheCubesOfACellWithTagsOfItsOwnStayAsLargeAsTheirTagsAreTold) {
  const CellDescription own = cell_with_an_own_tag();
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const CellDescription drawn = draw_story(own, seed, {}).cell;
    EXPECT_EQ(drawn.cube_mm, own.cube_mm) << seed;
    EXPECT_FALSE(has_many_cubes(drawn)) << seed;
  }
}

}  // namespace
}  // namespace pizarra::chaos
