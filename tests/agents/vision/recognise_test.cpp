#include <gtest/gtest.h>

#include "tests/agents/vision/eyes.hpp"

namespace pizarra {
namespace {

std::optional<SeenPair> find_in(const Scene& scene, const std::string& name, Random& random) {
  DrawnSight drawn(scene, random);
  return drawn.sight.find(learned_cell(), *learned_cell().find(name));
}

// One mark at a random place, distance (0.6 to 1.6 times the learned scale), yaw, quarter turn and tilt.
Scene random_view(const std::string& name, Random& random, SceneFace& face) {
  const double depth = 850 / random.uniform(0.65, 1.6);
  face = {.mark = drawn_as(name),
          .place = {random.uniform(-0.15, 0.2) * depth, random.uniform(-0.15, 0.15) * depth, depth},
          .yaw_deg = random.uniform(-35, 35),
          .quarter_turns = name == "end-effector" ? 0 : static_cast<int>(random.below(4)),
          .roll_deg = random.uniform(-8, 8)};
  Scene scene;
  scene.faces = {face};
  return scene;
}

TEST(Recognise, FindsEachMarkTurnedYawedAndScaledAndNothingElseInIt) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    for (const std::string& name : cell_marks()) {
      SceneFace face;
      const Scene scene = random_view(name, random, face);
      DrawnSight drawn(scene, random);
      for (const LearnedObject& object : learned_cell().all()) {
        const std::optional<SeenPair> found = drawn.sight.find(learned_cell(), object);
        if (object.name != name) {
          EXPECT_FALSE(found) << object.name << " in a view of " << name;
          continue;
        }
        ASSERT_TRUE(found) << name << " yaw " << face.yaw_deg << " depth " << face.place.z;
        const cv::Point2d truth = project(DrawnSight::model(), face.place, false);
        EXPECT_LT(cv::norm(found->left.centre - truth), 0.6) << name;
      }
    }
  }
}

TEST(Recognise, TellsFiveMarksApartInOneImage) {
  Random random(3);
  Scene scene;
  for (std::size_t i = 0; i < cell_marks().size(); ++i) {
    scene.faces.push_back(
        {.mark = drawn_as(cell_marks()[i]), .place = {-160 + 80.0 * static_cast<double>(i), 30, 860}});
  }
  for (std::size_t i = 0; i < cell_marks().size(); ++i) {
    const std::optional<SeenPair> found = find_in(scene, cell_marks()[i], random);
    ASSERT_TRUE(found) << cell_marks()[i];
    EXPECT_LT(cv::norm(found->left.centre - project(DrawnSight::model(), scene.faces[i].place, false)), 0.3);
  }
}

TEST(Recognise, OfTwoFacesOfOneYawedCubeTakesTheLarger) {
  Random random(4);
  // Faces of a 60 mm cube yawed by 35 degrees about its vertical axis.
  const double yaw = 35 * CV_PI / 180;
  const cv::Point3d middle(0, 0, 870);
  const SceneFace front{
      .mark = "circle", .place = middle + cv::Point3d(30 * std::sin(yaw), 0, -30 * std::cos(yaw)), .yaw_deg = 35};
  const SceneFace side{
      .mark = "circle", .place = middle + cv::Point3d(-30 * std::cos(yaw), 0, -30 * std::sin(yaw)), .yaw_deg = -55};
  Scene scene;
  scene.faces = {side, front};
  const std::optional<SeenPair> found = find_in(scene, "circle", random);
  ASSERT_TRUE(found);
  EXPECT_LT(cv::norm(found->left.centre - project(DrawnSight::model(), front.place, false)), 0.6);
}

TEST(Recognise, AnEmptyTableShowsNothing) {
  Random random(5);
  Scene scene;
  scene.faces = {{.mark = "none", .place = {0, 0, 850}}};
  scene.blots = {{.box = {40, 60, 12, 53}, .level = 30}, {.box = {200, 100, 30, 12}, .level = 220}};
  for (const std::string& name : cell_marks()) EXPECT_FALSE(find_in(scene, name, random)) << name;
}

TEST(Recognise, AMarkOfWhichAThirdIsHiddenIsNotSeen) {
  Random random(6);
  for (const std::string name : {"circle", "square", "cross", "triangle"}) {
    Scene scene;
    scene.faces = {{.mark = name, .place = {0, 0, 850}}};
    const cv::Point2d centre = project(DrawnSight::model(), scene.faces[0].place, false);
    for (const int level : {225, 150, 25}) {
      scene.blots = {{.box = {centre.x - 20, centre.y + 3, 40, 20}, .level = level}};
      EXPECT_FALSE(find_in(scene, name, random)) << name << " behind " << level;
      scene.blots = {{.box = {centre.x + 3, centre.y - 20, 20, 40}, .level = level}};
      EXPECT_FALSE(find_in(scene, name, random)) << name << " beside " << level;
    }
  }
}

TEST(Recognise, AMarkOfTheRightShapeAndTheWrongSizeIsNotTheObject) {
  Random random(7);
  Scene scene;
  // With a base line of 135 mm the same pair of images means a mark 1.5 times as large.
  scene.faces = {{.mark = "square", .place = {0, 0, 850}}};
  DrawnSight drawn(scene, random);
  StereoModel other = DrawnSight::model();
  other.base_line_mm = 135;
  StereoSight sight(drawn.sight.left(), drawn.sight.right(), other);
  EXPECT_FALSE(sight.find(learned_cell(), *learned_cell().find("square")));
}

// By its size the thing would be so near that the right image ends before it; but there its right half is, farther
// away.
TEST(Recognise, ALargerThingThatTheRightImageCutsOffIsNotANearerObject) {
  Random random(8);
  for (const int size : {32, 36, 40}) {
    for (double x = 30; x < 66; x += 3) {
      Scene scene;
      scene.ground = 170;
      scene.blots = {
          {.box = {x, 90, static_cast<double>(size), static_cast<double>(size)}, .level = 60, .disparity_px = 44}};
      EXPECT_FALSE(find_in(scene, "square", random)) << size << " px at " << x;
    }
  }
}

}  // namespace
}  // namespace pizarra
