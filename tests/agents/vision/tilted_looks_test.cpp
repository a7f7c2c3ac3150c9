// Tilted marks are found, and told at the right range. The pair that learned a mark on a face that is turned away sees
// it so, and its range by size takes the tilt into account.

#include "tests/agents/vision/tilted_looks.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <ostream>

#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

camera::StereoModel wide_camera() {
  return {.width = 640, .height = 480, .focal_px = 700, .centre_x_px = 319.5, .centre_y_px = 239.5};
}

camera::StereoModel alone(camera::StereoModel model) {
  model.base_line_mm = 0;
  model.learned_at_mm = 500;
  return model;
}

class Pitched : public testing::TestWithParam<std::tuple<const char*, int>> {};

// As a pair sees a cube that looks down at the table.
TEST_P(Pitched, MarksAreFoundInTheImagesTheyWereLearnedFrom) {
  const auto [mark, pitch_deg] = GetParam();
  Random random = Random(7).split(fmt::format("{} {}", mark, pitch_deg));
  for (const double roll_deg : {0.0, 20.0}) {
    TiltedLooks looks(camera::StereoModel{});
    const RangeView view{.mark = mark,
                         .place = {20, -10, 600},
                         .pitch_deg = static_cast<double>(pitch_deg),
                         .roll_deg = roll_deg,
                         .noise = 2,
                         .blur_px = 0.7};
    looks.learn(view, random);
    const Result<FoundMark> found = looks.find(view, TiltedLooks::Side::both, random);
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_TRUE(found->pair.right);
    EXPECT_GE(found->confidence, 0.9);
    const TrackSighting tracked = looks.track(view, 5, random);
    EXPECT_TRUE(tracked.seen);
    EXPECT_GE(tracked.confidence, 0.5);
  }
}

// Learned from the front, then tilted as far as one camera alone sees them.
TEST_P(Pitched, MarksAreFoundThatWereLearnedFromTheFront) {
  const auto [mark, pitch_deg] = GetParam();
  Random random = Random(7).split(fmt::format("front {} {}", mark, pitch_deg));
  TiltedLooks looks(camera::StereoModel{});
  RangeView view{.mark = mark, .place = {20, -10, 600}, .noise = 2, .blur_px = 0.7};
  looks.learn(view, random);
  view.pitch_deg = pitch_deg;
  const Result<FoundMark> found = looks.find(view, TiltedLooks::Side::both, random);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_TRUE(found->pair.right);
  EXPECT_GE(found->confidence, 0.9);
}

std::string pitched_name(const testing::TestParamInfo<Pitched::ParamType>& one) {
  const int pitch_deg = std::get<1>(one.param);
  return fmt::format("{}{}{}", std::get<0>(one.param), pitch_deg < 0 ? "Forward" : "Back", std::abs(pitch_deg));
}

INSTANTIATE_TEST_SUITE_P(Marks, Pitched,
                         testing::Combine(testing::Values("square", "cross", "circle", "triangle"),
                                          testing::Values(-45, -35, -25, 25, 35, 45)),
                         pitched_name);

struct Oblique {
  const char* name;
  double yaw_deg;
  double pitch_deg;

  friend void PrintTo(const Oblique& oblique, std::ostream* out) { *out << oblique.name; }
};

constexpr Oblique all_oblique[] = {
    {"RightAndBack", 25, 25}, {"LeftAndBack", -25, 30}, {"RightAndForward", 30, -30}, {"LeftAndForward", -20, -40}};

class ObliquelyTilted : public testing::TestWithParam<std::tuple<const char*, Oblique>> {};

// A face that is turned about both axes at once is as high as neither of them alone makes it.
TEST_P(ObliquelyTilted, MarksAreFoundSurelyByAPairThatLearnedThemFromTheFront) {
  const auto [mark, oblique] = GetParam();
  Random random = Random(7).split(fmt::format("oblique {} {}", mark, oblique.name));
  TiltedLooks looks(wide_camera());
  RangeView view{.mark = mark, .place = {20, -10, 500}, .noise = 2, .blur_px = 0.7};
  looks.learn(view, random);
  view.yaw_deg = oblique.yaw_deg;
  view.pitch_deg = oblique.pitch_deg;
  for (const cv::Point3d& place : {cv::Point3d(20, -10, 450), cv::Point3d(-90, 60, 550), cv::Point3d(80, 90, 700)}) {
    SCOPED_TRACE(place.z);
    view.place = place;
    view.roll_deg = random.uniform(-180, 180);
    const Result<FoundMark> found = looks.find(view, TiltedLooks::Side::both, random);
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_TRUE(found->pair.right);
    EXPECT_GE(found->confidence, 0.9);
  }
}

INSTANTIATE_TEST_SUITE_P(Marks, ObliquelyTilted,
                         testing::Combine(testing::Values("square", "cross", "circle", "triangle"),
                                          testing::ValuesIn(all_oblique)),
                         [](const auto& one) {
                           return std::string(std::get<0>(one.param)) + std::get<1>(one.param).name;
                         });

struct Spread {
  int tries = 0;
  int told = 0;
  int within_two = 0;
  double worst_mm = 0;
  double squared = 0;

  void count(double off_mm, double spread_mm) {
    ++told;
    within_two += std::abs(off_mm) < 2 * spread_mm ? 1 : 0;
    worst_mm = std::max(worst_mm, std::abs(off_mm));
    squared += off_mm * off_mm / (spread_mm * spread_mm);
  }
  double percent_within_two() const { return 100.0 * within_two / told; }
  double rms() const { return std::sqrt(squared / told); }
};

Spread spread_of(const TiltedLooks& looks, const std::string& mark, int most_roll_deg, double most_tilt_deg,
                 Random& random) {
  const int tries = campaign(80, 200);
  Spread out{.tries = tries};
  for (int i = 0; i < tries; ++i) {
    const double tilt_deg = random.uniform(30, most_tilt_deg);
    const double towards = random.uniform(0, 2 * CV_PI);
    RangeView view{.mark = mark,
                   .place = {random.uniform(-100, 100), random.uniform(-70, 70), random.uniform(400, 900)},
                   .yaw_deg = tilt_deg * std::cos(towards),
                   .pitch_deg = tilt_deg * std::sin(towards),
                   .roll_deg = random.uniform(-most_roll_deg, most_roll_deg),
                   .noise = random.uniform(1, 5),
                   .blur_px = random.uniform(0.4, 1)};
    const Result<FoundMark> found = looks.find(view, TiltedLooks::Side::left_alone, random);
    if (!found || !found->range) continue;
    out.count(found->range->mm - cv::norm(view.place), found->range->spread_mm);
  }
  return out;
}

TEST(RangeBySize, OfATiltedTagBeforeOneCameraIsWithinItsSpread) {
  Random random(3);
  TiltedLooks looks(alone(wide_camera()));
  looks.learn({.mark = "tag", .place = {0, 0, 500}, .noise = 2, .blur_px = 0.7}, random);
  const Spread spread = spread_of(looks, "tag", 180, 55, random);
  ASSERT_GT(spread.told, 3 * spread.tries / 4);
  EXPECT_GE(spread.percent_within_two(), 93);
  EXPECT_LT(spread.worst_mm, 40);
  EXPECT_GT(spread.rms(), 0.3) << "told to be worse than it is";
}

TEST(RangeBySize, OfATiltedTagThatTheLeftCameraAloneReadsIsWithinItsSpread) {
  Random random(3);
  TiltedLooks looks(wide_camera());
  looks.learn({.mark = "tag", .place = {0, 0, 500}, .noise = 2, .blur_px = 0.7}, random);
  const Spread spread = spread_of(looks, "tag", 180, 55, random);
  ASSERT_GT(spread.told, 3 * spread.tries / 4);
  EXPECT_GE(spread.percent_within_two(), 93);
  EXPECT_LT(spread.worst_mm, 40);
  EXPECT_GT(spread.rms(), 0.3) << "told to be worse than it is";
}

// One camera says by how a tag looks that it was learned turned away.
TEST(RangeBySize, OfATagThatWasLearnedTiltedIsWithinItsSpread) {
  Random random(3);
  TiltedLooks looks(alone(wide_camera()));
  looks.learn({.mark = "tag", .place = {0, 0, 500}, .pitch_deg = 40, .noise = 2, .blur_px = 0.7}, random);
  const Spread spread = spread_of(looks, "tag", 180, 55, random);
  ASSERT_GT(spread.told, 3 * spread.tries / 4);
  EXPECT_GE(spread.percent_within_two(), 90);
}

class CoveredSquare : public testing::Test {
 protected:
  CoveredSquare() : looks_(alone(wide_camera())) { looks_.learn(square, random_); }

  // Something as far away as the square covers so much of it from the left.
  Result<FoundMark> find_with(double covered_px) {
    constexpr double width_px = 61.6;
    constexpr double cover_px = 100;
    RangeView view = square;
    const double beside_px = (width_px + cover_px) / 2 - covered_px;
    view.cover = bench::placed(bench::box(cover_px, cover_px), middle - cv::Point2d(beside_px, 0), 1, 0);
    return looks_.find(view, TiltedLooks::Side::left_alone, random_);
  }

  const cv::Point2d middle = {319.5, 239.5};
  const RangeView square = {.mark = "square", .place = {0, 0, 500}, .noise = 2, .blur_px = 0.7};

 private:
  Random random_ = Random(3);
  TiltedLooks looks_;
};

// The rest looks like a square aslant as well, on ground that no square has. The three sides in view speak for a square
// that faces the camera.
TEST_F(CoveredSquare, IsFoundWhereItIsWithAQuarterHidden) {
  const Result<FoundMark> found = find_with(15.4);
  ASSERT_TRUE(found) << describe(found.error());
  EXPECT_LT(cv::norm(found->pair.left.centre - middle), 0.1);
  EXPECT_GE(found->confidence, 0.4);
  EXPECT_LE(found->confidence, 0.5) << "the hidden quarter may be of anything";
  ASSERT_TRUE(found->pose);
  EXPECT_NEAR(found->pose->place_mm[2], square.place.z, 5);
  EXPECT_GT(std::abs(found->pose->turn(2, 2)), std::cos(5 * CV_PI / 180)) << "it faces the camera";
}

// The rest is too little to say how far a square reaches, and as a square aslant its ground contradicts it.
TEST_F(CoveredSquare, IsNotSeenWhereNothingSpeaksForIt) {
  const Result<FoundMark> found = find_with(40);
  ASSERT_FALSE(found) << found->confidence;
  EXPECT_EQ(found.error().symbol, "not-seen");
}

// One that is whole is told, and never as if nothing spoke for it, however it is tilted and as far away as it may be.
TEST(Found, WhatIsWholeIsNeverToldAsIfNothingSpokeForIt) {
  for (const char* mark : {"circle", "square", "cross", "triangle"}) {
    SCOPED_TRACE(mark);
    Random random(3);
    TiltedLooks looks(alone(wide_camera()));
    RangeView view{.mark = mark, .place = {0, 0, 500}, .noise = 2, .blur_px = 0.7};
    looks.learn(view, random);
    view.place.z = 800;
    view.yaw_deg = 40;
    const Result<FoundMark> found = looks.find(view, TiltedLooks::Side::left_alone, random);
    ASSERT_TRUE(found) << describe(found.error());
    EXPECT_GE(found->confidence, 0.05);
  }
}

// Marks that are as wide as high look foreshortened one way alone, whichever that is.
TEST(RangeBySize, OfATiltedShapeBeforeOneCameraIsWithinItsSpread) {
  for (const char* mark : {"circle", "square", "cross"}) {
    SCOPED_TRACE(mark);
    Random random(3);
    TiltedLooks looks(alone(wide_camera()));
    looks.learn({.mark = mark, .place = {0, 0, 500}, .noise = 2, .blur_px = 0.7}, random);
    const Spread spread = spread_of(looks, mark, 180, 45, random);
    ASSERT_GT(spread.told, spread.tries / 4);
    EXPECT_GE(spread.percent_within_two(), 90);
    EXPECT_LT(spread.worst_mm, 60);
  }
}

// Beside the middle of the image it is longer than one that is parallel to the image.
TEST(RangeBySize, OfATrackedTriangleThatLooksAtTheCameraFromBesideTheMiddleIsRight) {
  Random random(3);
  camera::StereoModel wide = wide_camera();
  wide.focal_px = 500;
  TiltedLooks looks(alone(wide));
  looks.learn({.mark = "triangle", .place = {0, 0, 500}, .noise = 2, .blur_px = 0.7}, random);
  for (const double x_mm : {-340.0, 340.0}) {
    for (const double yaw_deg : {-25.0, 25.0}) {
      SCOPED_TRACE(fmt::format("x {} yaw {}", x_mm, yaw_deg));
      const RangeView view{.mark = "triangle",
                           .place = {x_mm, 60, 600},
                           .yaw_deg = yaw_deg,
                           .roll_deg = random.uniform(-180, 180),
                           .noise = 2,
                           .blur_px = 0.7};
      const TrackSighting told = looks.track(view, 5, random);
      ASSERT_TRUE(told.seen);
      EXPECT_NEAR(told.range_mm / cv::norm(view.place), 1, 0.03);
    }
  }
}

}  // namespace
}  // namespace pizarra::vision
