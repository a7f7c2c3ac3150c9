// A square of which something hides a part, and what only looks like one.

#include <cmath>
#include <gtest/gtest.h>

#include "agents/vision/objects/part_look.hpp"
#include "agents/vision/sight/mark_finder.hpp"
#include "tests/agents/vision/drawn_planes.hpp"

namespace pizarra::vision {
namespace {

// Lays grey over all that is farther than so much along a direction, px from the middle.
void cover(cv::Mat1b& image, cv::Point2d middle, double beyond_px, double direction, std::uint8_t level) {
  const cv::Point2d away(std::cos(direction), std::sin(direction));
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const cv::Point2d p = cv::Point2d(x, y) - middle;
      if (p.dot(away) > beyond_px && cv::norm(p) < 75) image(y, x) = level;
    }
  }
}

std::vector<PartLook> parts_of_square(const cv::Mat1b& image, const LearnedObjects& objects) {
  const ImageCut cut = look_at(image, {0, 0, image.cols, image.rows}, noise_of(image));
  return look_for_parts(cut, edge_chains(cut), objects, *objects.find("square"), {600, {319.5, 239.5}});
}

TEST(Plane, OfASquareThatSomethingHidesACornerOfIsWhereTheWholeIs) {
  Random random(9);
  LearnedObjects objects;
  objects.add("square", learned(square, random));
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    // Of each side a part shows.
    const double from = CV_PI / 4 + random.uniform(-0.2, 0.2);
    const double turned = random.uniform(-3, 3);
    const cv::Matx33d turn = turned_about({0, 0, turned});
    const cv::Vec3d place(random.uniform(-80, 80), random.uniform(-60, 60), random.uniform(400, 550));
    const cv::Point2d middle = projected({{0, 0}}, turn, place).front();
    cv::Mat1b image = filled(projected(square, turn, place), random);
    const double side_px = 600 * 2 * half_mm / place[2];
    cover(image, middle, 0.28 * side_px, turned + from, i % 2 == 0 ? 90 : 130);
    const std::vector<PartLook> parts = parts_of_square(image, objects);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_LT(cv::norm(parts.front().fit.in_image({0, 0}) - middle), 0.5);
    EXPECT_GT(parts.front().part.hidden, 0.1);
  }
}

// How far the other sides reach behind the cover is told by how they meet, which goes with how they are shortened.
TEST(Plane, OfASquareThatSomethingHidesASideOfIsWhereTheWholeIs) {
  Random random(21);
  LearnedObjects objects;
  objects.add("square", learned(square, random));
  int told = 0;
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const double turned = random.uniform(-3, 3);
    const double axis = random.uniform(-3, 3);
    const double tilt = random.uniform(0, 0.26);
    const cv::Matx33d turn =
        turned_about({tilt * std::cos(axis), tilt * std::sin(axis), 0}) * turned_about({0, 0, turned});
    const cv::Vec3d place(random.uniform(-80, 80), random.uniform(-60, 60), random.uniform(400, 500));
    const cv::Point2d middle = projected({{0, 0}}, turn, place).front();
    cv::Mat1b image = filled(projected(square, turn, place), random);
    const double side_px = 600 * 2 * half_mm / place[2];
    cover(image, middle, random.uniform(0.1, 0.25) * side_px, turned, i % 2 == 0 ? 90 : 130);
    const std::vector<PartLook> parts = parts_of_square(image, objects);
    if (parts.empty()) continue;
    ++told;
    ASSERT_EQ(parts.size(), 1U);
    const PlaneFit& fit = parts.front().fit;
    const double off_px = cv::norm(fit.in_image({0, 0}) - middle);
    EXPECT_LT(off_px, 1.5);
    EXPECT_LT(off_px, 3 * fit.middle_spread_px);
  }
  EXPECT_GE(told, 17);
}

// A side and parts of two others are short edges, and leave the middle open by a pixel: they are told as the levels on
// both sides are those of one print.
TEST(Plane, OfASquareThatIsHalfHiddenIsWhereTheWholeIs) {
  Random random(22);
  LearnedObjects objects;
  objects.add("square", learned(square, random));
  int within = 0;
  for (int i = 0; i < 20; ++i) {
    SCOPED_TRACE(i);
    const double turned = random.uniform(-3, 3);
    const double axis = random.uniform(-3, 3);
    const double tilt = random.uniform(0, 0.2);
    const cv::Matx33d turn =
        turned_about({tilt * std::cos(axis), tilt * std::sin(axis), 0}) * turned_about({0, 0, turned});
    const cv::Vec3d place(random.uniform(-80, 80), random.uniform(-60, 60), random.uniform(400, 600));
    const cv::Point2d middle = projected({{0, 0}}, turn, place).front();
    cv::Mat1b image = filled(projected(square, turn, place), random);
    cover(image, middle, 0, turned + random.uniform(-0.3, 0.3), i % 2 == 0 ? 90 : 130);
    const std::vector<PartLook> parts = parts_of_square(image, objects);
    if (parts.empty()) continue;
    ASSERT_EQ(parts.size(), 1U);
    const PlaneFit& fit = parts.front().fit;
    const double off_px = cv::norm(fit.in_image({0, 0}) - middle);
    EXPECT_LT(off_px, 3 * fit.middle_spread_px);
    within += off_px < 1.5 ? 1 : 0;
  }
  EXPECT_GE(within, 16);
}

// A cover that is nearly as light as the paper is another thing all the same.
TEST(Plane, OfASquareIsWhereTheWholeIsBehindWhatIsALittleLighterThanItsGround) {
  Random random(24);
  LearnedObjects objects;
  objects.add("square", learned(square, random));
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const double turned = random.uniform(-3, 3);
    const cv::Vec3d place(random.uniform(-80, 80), random.uniform(-60, 60), random.uniform(400, 550));
    const cv::Matx33d turn = turned_about({0, 0, turned});
    const cv::Point2d middle = projected({{0, 0}}, turn, place).front();
    cv::Mat1b image = filled(projected(square, turn, place), random);
    cover(image, middle, 0.28 * 600 * 2 * half_mm / place[2], turned + CV_PI / 4, i % 2 == 0 ? 212 : 218);
    const std::vector<PartLook> parts = parts_of_square(image, objects);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_LT(cv::norm(parts.front().fit.in_image({0, 0}) - middle), 0.5);
  }
}

// A faint square that is seen aslant is less likely the mark than a part of a bold one that faces the camera.
TEST(Plane, OfASquareIsWhereAPartFacesTheCameraRatherThanWhereAllOfOneIsTurnedAway) {
  Random random(25);
  LearnedObjects objects;
  objects.add("square", learned(square, random));
  const camera::StereoModel model = one_camera();
  int within = 0;
  for (int i = 0; i < 12; ++i) {
    SCOPED_TRACE(i);
    const double turned = random.uniform(-3, 3);
    const cv::Matx33d turn = turned_about({0, 0, turned});
    const cv::Vec3d place(-80, random.uniform(-60, 60), random.uniform(400, 500));
    const cv::Point2d middle = projected({{0, 0}}, turn, place).front();
    cv::Mat image = filled(projected(square, turn, place), random);
    const cv::Matx33d aslant = turned_about({random.uniform(0.5, 1.1), 0.2, 0});
    const Corners other = projected(square, aslant, {80, 0, random.uniform(350, 400)});
    image = cv::min(image, cv::max(filled(other, random), 60));
    cv::Mat1b grey = image;
    cover(grey, middle, 0.28 * 600 * 2 * half_mm / place[2], turned + CV_PI / 4, 110);
    StereoSight sight(image, cv::Mat1b::zeros(image.size()), model);
    const Result<FoundMark> found = MarkFinder(objects).find(sight, *objects.find("square"), {});
    ASSERT_TRUE(found);
    within += cv::norm(found->pair.left.centre - middle) < 1 ? 1 : 0;
  }
  EXPECT_GE(within, 10);
}

// It is more often a window of a house; but of a print that was learned as faint it is not.
TEST(Plane, OfAFaintSquareThatIsTurnedFarAwayIsNotFound) {
  Random random(26);
  LearnedSample sample = learned(square, random);
  LearnedObjects objects;
  objects.add("square", sample);
  LearnedObjects as_faint;
  sample.contrast = std::log(200.0 / 60);
  as_faint.add("square", sample);
  LearnedObjects not_said;
  sample.contrast = 0;
  not_said.add("square", sample);
  const camera::StereoModel model = one_camera();
  const auto found_in = [&](const LearnedObjects& of, double tilt, int level) {
    const Corners corners = projected(square, turned_about({tilt, 0.2, 0}), {20, 0, 350});
    const cv::Mat image = cv::max(filled(corners, random), level);
    StereoSight sight(image, cv::Mat1b::zeros(image.size()), model);
    return MarkFinder(of).find(sight, *of.find("square"), {});
  };
  for (const double tilt : {1.11, 1.13, 1.15}) {
    SCOPED_TRACE(tilt);
    const Result<FoundMark> found = found_in(objects, tilt, 60);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().symbol, "not-seen");
    EXPECT_EQ(found.error().sentence, "a mark is like it, but its print is much fainter than it was learned");
    for (const LearnedObjects* others : {&as_faint, &not_said}) {
      const Result<FoundMark> by_others = found_in(*others, tilt, 60);
      ASSERT_TRUE(by_others);
      EXPECT_GT(by_others->confidence, 0.9);
    }
  }
  const Result<FoundMark> facing = found_in(objects, 0.2, 60);
  ASSERT_TRUE(facing);
  EXPECT_GT(facing->confidence, 0.85);
  const Result<FoundMark> bold = found_in(objects, 1.1, 25);
  ASSERT_TRUE(bold);
  EXPECT_GT(bold->confidence, 0.9);
}

// Its rim is all of a circle's border, and there is nothing inside.
TEST(Plane, OfACircleIsNotARing) {
  Random random(27);
  LearnedObjects objects;
  objects.add("circle", learned(circle(), random));
  const camera::StereoModel model = one_camera();
  for (const double inner : {0.5, 0.6, 0.7, 0.8}) {
    SCOPED_TRACE(inner);
    Corners hole = circle();
    for (cv::Point2d& p : hole) p *= inner;
    const cv::Vec3d place(random.uniform(-80, 80), random.uniform(-60, 60), random.uniform(350, 500));
    const cv::Matx33d facing = cv::Matx33d::eye();
    const cv::Mat image = cv::max(filled(projected(circle(), facing, place), random),
                                  225 - filled(projected(hole, facing, place), random));
    StereoSight sight(image, cv::Mat1b::zeros(image.size()), model);
    EXPECT_FALSE(MarkFinder(objects).find(sight, *objects.find("circle"), {}));
  }
}

TEST(Plane, OfASquareIsNotTheArmOfANearCross) {
  Random random(23);
  LearnedObjects objects;
  objects.add("square", learned(square, random));
  objects.add("cross", learned(cross, random));
  const camera::StereoModel model = one_camera();
  for (const double depth_mm : {270.0, 300.0, 330.0, 360.0}) {
    SCOPED_TRACE(depth_mm);
    const cv::Matx33d turn = turned_about({0, 0, random.uniform(-3, 3)});
    const cv::Mat image = filled(projected(cross, turn, {10, -5, depth_mm}), random);
    StereoSight sight(image, cv::Mat1b::zeros(image.size()), model);
    MarkFinder finder(objects);
    EXPECT_TRUE(finder.find(sight, *objects.find("cross"), {}));
    EXPECT_FALSE(finder.find(sight, *objects.find("square"), {}));
  }
}

TEST(Plane, AThingWithoutAPartOfTheSquareIsNoneThatSomethingHides) {
  Random random(10);
  LearnedObjects objects;
  objects.add("square", learned(square, random));
  // Where the rest should be is ground.
  Corners cut_off = square;
  cut_off[1].x = 0;
  cut_off.insert(cut_off.begin() + 2, {half_mm, 0});
  EXPECT_TRUE(parts_of_square(filled(projected(cut_off, cv::Matx33d::eye(), {0, 0, 450}), random), objects).empty());
}

}  // namespace
}  // namespace pizarra::vision
