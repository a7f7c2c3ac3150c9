// A hand hides a mark. Meanwhile another one like it appears elsewhere, or a copy of another size comes to light.
// Nothing that cannot be known is told surely, and the learned mark is found again.

#include <gtest/gtest.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"

namespace pizarra::vision {
namespace {

constexpr double surely = 0.9;

enum class Eyes : std::uint8_t { pair, one };

class Swapped : public testing::TestWithParam<std::tuple<std::string, Eyes>> {
 protected:
  Swapped() {
    if (std::get<1>(GetParam()) == Eyes::one) eyes.base_line_mm = 0;
    if (std::get<1>(GetParam()) == Eyes::one) eyes.learned_at_mm = 850;
    EXPECT_TRUE(tracker.add(*learned_cell().find(name())));
  }
  std::string name() const { return std::get<0>(GetParam()); }
  SceneFace face_at(double x_mm, double y_mm, double depth_mm = 850) const {
    return {.mark = drawn_as(name()), .place = {x_mm, y_mm, depth_mm}};
  }
  static cv::Point2d centre_of(const SceneFace& face) { return project(DrawnSight::model(), face.place, false); }
  TrackSighting see() {
    DrawnSight drawn(scene, random);
    const cv::Mat nothing = cv::Mat::zeros(eyes.height, eyes.width, CV_8UC1);
    StereoSight sight(drawn.sight.left(), eyes.is_single() ? nothing : drawn.sight.right(), eyes);
    now += 100ms;
    return tracker.update(sight, now).front();
  }
  void hide(const SceneFace& face) {
    const cv::Point2d centre = centre_of(face);
    scene.blots = {{.box = {centre.x - 25, centre.y - 25, 50, 50}, .level = 150, .disparity_px = 46}};
  }
  static bool is_at(const TrackSighting& sighting, const SceneFace& face) {
    return sighting.seen && cv::norm(sighting.centre - centre_of(face)) < 1;
  }
  // From anew, and hidden for so many frames.
  void follow_and_hide(const SceneFace& tracked, int hidden_frames) {
    tracker.clear();
    EXPECT_TRUE(tracker.add(*learned_cell().find(name())));
    scene.faces = {tracked};
    scene.blots.clear();
    for (int frame = 0; frame < 4; ++frame) EXPECT_TRUE(is_at(see(), tracked));
    hide(tracked);
    for (int frame = 0; frame < hidden_frames; ++frame) EXPECT_FALSE(see().seen);
  }

  camera::StereoModel eyes = DrawnSight::model();
  Scene scene;
  Random random{17};
  Time now = {};
  MarkTracker tracker{learned_cell()};
};

TEST_P(Swapped, ATwinIsNotSureWhileTheTrackedOneMayBeHidden) {
  const SceneFace tracked = face_at(-70, -40);
  const SceneFace twin = face_at(90, 40);
  for (const int hidden_frames : {3, 10, 30}) {
    SCOPED_TRACE(testing::Message() << hidden_frames << " frames before the twin appears");
    follow_and_hide(tracked, hidden_frames);
    scene.faces = {tracked, twin};
    const int doubted_frames = std::max(hidden_frames, 5);
    for (int frame = 0; frame < doubted_frames; ++frame) {
      const TrackSighting sighting = see();
      EXPECT_TRUE(is_at(sighting, twin)) << frame;
      EXPECT_LT(sighting.confidence, surely) << frame;
    }
    scene.blots.clear();
    const TrackSighting again = see();
    EXPECT_TRUE(is_at(again, tracked));
    EXPECT_GT(again.confidence, surely);
    for (int frame = 0; frame < 10; ++frame) EXPECT_TRUE(is_at(see(), tracked));
  }
}

TEST_P(Swapped, WhatWasPutElsewhereIsSureAgainWhenItHasBeenFollowedForAWhile) {
  const SceneFace tracked = face_at(-70, -40);
  for (const int hidden_frames : {1, 10, 100}) {
    SCOPED_TRACE(testing::Message() << hidden_frames << " frames hidden");
    follow_and_hide(tracked, hidden_frames);
    scene.faces = {face_at(80, 40)};
    scene.blots.clear();
    const int doubted_frames = std::clamp(hidden_frames, 5, 50);
    for (int frame = 0; frame < doubted_frames; ++frame) EXPECT_TRUE(is_at(see(), scene.faces[0]));
    TrackSighting sighting = see();
    for (int frame = 0; frame < 2; ++frame) sighting = see();
    EXPECT_TRUE(is_at(sighting, scene.faces[0]));
    EXPECT_GT(sighting.confidence, surely);
  }
}

TEST_P(Swapped, WhatMovedWhenItWasHiddenIsSureWhereverItMayHaveGoneSince) {
  constexpr double step_mm = 4;
  constexpr int hidden_frames = 10;
  for (const double aside_deg : {0.0, 60.0, 120.0}) {
    SCOPED_TRACE(aside_deg);
    tracker.clear();
    EXPECT_TRUE(tracker.add(*learned_cell().find(name())));
    scene.blots.clear();
    SceneFace tracked = face_at(-70, -40);
    for (int frame = 0; frame < 6; ++frame) {
      scene.faces = {tracked = face_at(-70 + frame * step_mm, -40)};
      EXPECT_TRUE(is_at(see(), tracked));
    }
    hide(tracked);
    for (int frame = 0; frame < hidden_frames; ++frame) EXPECT_FALSE(see().seen);
    scene.blots.clear();
    const double aside = aside_deg * CV_PI / 180;
    const double way_mm = 0.9 * hidden_frames * step_mm;
    scene.faces = {face_at(tracked.place.x + way_mm * std::cos(aside), tracked.place.y + way_mm * std::sin(aside))};
    const TrackSighting sighting = see();
    EXPECT_TRUE(is_at(sighting, scene.faces[0]));
    EXPECT_GT(sighting.confidence, surely);
  }
}

// As far from the learned size as it may be and be the object for a pair, which knows its size; and for one camera. A
// smaller mark where the tracked one rested may be that one, covered.
TEST_P(Swapped, ACopyOfAnotherSizeIsFoundAgain) {
  const bool is_pair = std::get<1>(GetParam()) == Eyes::pair;
  for (const double scale : {0.94, 1.03, 0.75, 1.3}) {
    if (is_pair && std::abs(scale - 1) > 0.1) continue;
    for (const bool elsewhere : {false, true}) {
      for (const double step_mm : {0.0, 4.0}) {
        if (scale < 1 && !elsewhere && step_mm == 0) continue;
        SCOPED_TRACE(testing::Message() << scale << " times as large, " << (elsewhere ? "elsewhere" : "in its place")
                                        << ", " << step_mm << " mm a frame");
        tracker.clear();
        ASSERT_TRUE(tracker.add(*learned_cell().find(name())));
        scene.blots.clear();
        double x_mm = -60;
        for (int frame = 0; frame < 6; ++frame) {
          x_mm += step_mm;
          scene.faces = {face_at(x_mm, 0)};
          EXPECT_TRUE(see().seen);
        }
        hide(scene.faces[0]);
        for (int frame = 0; frame < 10; ++frame) EXPECT_FALSE(see().seen);
        scene.blots.clear();
        scene.faces = {face_at(elsewhere ? 80 : x_mm, 0)};
        scene.faces[0].scale = scale;
        see();
        const TrackSighting sighting = see();
        EXPECT_TRUE(is_at(sighting, scene.faces[0]));
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Marks, Swapped,
                         testing::Combine(testing::ValuesIn(cell_marks()), testing::Values(Eyes::pair, Eyes::one)),
                         [](const auto& one) {
                           std::string name = std::get<0>(one.param);
                           std::erase(name, '-');
                           return name + (std::get<1>(one.param) == Eyes::pair ? "ByAPair" : "ByOneCamera");
                         });

}  // namespace
}  // namespace pizarra::vision
