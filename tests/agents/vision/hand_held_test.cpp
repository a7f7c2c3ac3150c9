// A printed sheet learned from photographs that a hand took one after the other: each moved, turned a little, nearer or
// farther away than the one before.

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "agents/vision/sight/mark_learner.hpp"
#include "tests/agents/vision/photograph.hpp"

namespace pizarra::vision {
namespace {

constexpr double usual_mm = 480;

camera::StereoModel camera_of(const Photograph& photograph) {
  return {.width = photograph.size.width,
          .height = photograph.size.height,
          .focal_px = photograph.focal_px(),
          .centre_x_px = (photograph.size.width - 1) / 2.0,
          .centre_y_px = (photograph.size.height - 1) / 2.0,
          .base_line_mm = 0,
          .learned_at_mm = usual_mm};
}

cv::Mat1b grey_of(const Photograph& photograph, Random& random) {
  cv::Mat1b out;
  cv::cvtColor(photograph.take(random), out, cv::COLOR_BGR2GRAY);
  return out;
}

class HandHeld : public testing::TestWithParam<cv::Size> {
 protected:
  explicit HandHeld(std::vector<PrintedShape> shapes = printed_shapes()) {
    photograph.size = GetParam();
    photograph.distance_mm = usual_mm;
    photograph.shapes = std::move(shapes);
  }

  // By so many px at the width of 320, and back towards the middle.
  void move(double most_px) {
    if (most_px == 0) return;
    const double mm_a_px = usual_mm / (0.87 * 320);
    const double step = random.uniform(1.5, most_px) * mm_a_px;
    const cv::Point2d now = photograph.aside_mm;
    for (int direction = 0; direction < 6; ++direction) {
      const double angle = random.uniform(0, 2 * CV_PI);
      const cv::Point2d next = now + step * cv::Point2d(std::cos(angle), std::sin(angle));
      if (direction == 0 || cv::norm(next) < cv::norm(photograph.aside_mm)) photograph.aside_mm = next;
    }
    const auto drift = [&](double& value, double most, double low, double high) {
      value = std::clamp(value + random.uniform(-most, most), low, high);
    };
    drift(photograph.roll_deg, most_turn_deg, -2 * most_turn_deg, 2 * most_turn_deg);
    drift(photograph.tilt_deg, 4, -10, 10);
    drift(photograph.pan_deg, 4, -10, 10);
    drift(photograph.distance_mm, 0.03 * usual_mm, 0.92 * usual_mm, 1.08 * usual_mm);
  }

  // Clicks on the shape there; of what is learned, each contour must have been that one's.
  Result<LearnedSample> learn(cv::Point2d at_mm, double most_px) {
    const LearnedObjects none;
    MarkLearner learner("thing", photograph.project(at_mm) + cv::Point2d(1, 1), none);
    MarkContour last;
    while (!learner.done()) {
      const cv::Mat1b grey = grey_of(photograph, random);
      const camera::StereoModel model = camera_of(photograph);
      StereoSight sight(grey, grey, model);
      const Result<void> fed = learner.feed(sight);
      if (!fed) return fail(fed);
      const cv::Point2d there = photograph.project(at_mm);
      if (learner.contour() != last) {
        EXPECT_GT(cv::pointPolygonTest(learner.contour(), cv::Point2f(there), false), 0) << "another shape's";
      }
      last = learner.contour();
      move(most_px);
    }
    return learner.sample();
  }

  Random random{3};
  double most_turn_deg = 4;  // from one to the next
  Photograph photograph;
};

TEST_P(HandHeld, APhotographedShapeIsFollowedAndLearned) {
  const double most_px[] = {4, 60, 15, 60};
  for (std::size_t i = 0; i < printed_shapes().size(); ++i) {
    const PrintedShape& shape = printed_shapes()[i];
    SCOPED_TRACE(fmt::format("{}, moved by up to {} px", shape.name, most_px[i]));
    const Result<LearnedSample> sample = learn(shape.at_mm, most_px[i]);
    ASSERT_TRUE(sample) << sample.error().symbol << ": " << sample.error().sentence;
    EXPECT_LT(sample->roundness_spread, 0.01);
    // 44 mm across, its standard deviation along y from a fifth to a third of that.
    EXPECT_GT(sample->size_mm, 0.18 * 44);
    EXPECT_LT(sample->size_mm, 0.36 * 44);
  }
}

// How much of a template is neither the shape nor the ground.
std::ptrdiff_t blurred(const LearnedSample& sample) {
  return std::ranges::count_if(sample.picture, [](std::uint8_t level) { return level >= 3 && level <= 12; });
}

// Its picture is as sharp as one of a sheet that rests.
TEST_P(HandHeld, WhatIsLearnedIsNotSmeared) {
  most_turn_deg = 9;
  for (const std::size_t i : {1, 3}) {
    const PrintedShape& shape = printed_shapes()[i];
    SCOPED_TRACE(shape.name);
    const Photograph before = photograph;
    const Result<LearnedSample> rested = learn(shape.at_mm, 0);
    const Result<LearnedSample> moved = learn(shape.at_mm, 15);
    photograph = before;
    ASSERT_TRUE(rested && moved);
    // A turned one has more edges that are aslant.
    EXPECT_LT(blurred(*moved), 1.45 * blurred(*rested));
  }
}

class Twins : public HandHeld {
 protected:
  Twins() : HandHeld({}) {}
  // Learned, or refused as what cannot be told: never another of its like.
  void expect_learned(const std::vector<PrintedShape>& shapes, std::size_t clicked) {
    photograph.shapes = shapes;
    for (const double most_px : {15.0, 60.0}) {
      SCOPED_TRACE(fmt::format("{} shapes, moved by up to {} px", shapes.size(), most_px));
      const Result<LearnedSample> sample = learn(shapes[clicked].at_mm, most_px);
      EXPECT_TRUE(sample) << sample.error().symbol << ": " << sample.error().sentence;
    }
  }
};

TEST_P(Twins, TheOneThatWasClickedOnIsLearnedBesideItsLike) {
  expect_learned({{"circle", {-30, 0}}, {"circle", {30, 0}}}, 0);
  expect_learned({{"square", {-90, 0}}, {"square", {-30, 0}}, {"square", {30, 0}}, {"square", {90, 0}}}, 1);
  expect_learned({{"circle", {-70, -50}},
                  {"circle", {0, -50}},
                  {"circle", {70, -50}},
                  {"circle", {-70, 50}},
                  {"circle", {0, 50}},
                  {"circle", {70, 50}}},
                 4);
}

// Of a row as wide as the image, moved by just the distance between two, each is where another was.
TEST_P(Twins, WhereNobodyCanTellWhichItWasItIsRefused) {
  const double unit = GetParam().width / 320.0;
  const double apart = 40 * unit;
  const LearnedObjects none;
  cv::RNG noise(5);
  const auto row = [&](double moved) {
    cv::Mat1f picture(GetParam(), 200.F);
    for (double x = moved - 4 * apart; x < GetParam().width + 4 * apart; x += apart) {
      cv::circle(picture, cv::Point(cvRound(x), GetParam().height / 2), cvRound(10 * unit), 30.F, -1, cv::LINE_AA);
    }
    cv::GaussianBlur(picture, picture, {}, 0.8);
    cv::Mat1f grains(GetParam());
    noise.fill(grains, cv::RNG::NORMAL, 0, 2);
    cv::Mat1b out;
    cv::Mat(picture + grains).convertTo(out, CV_8U);
    return out;
  };
  const camera::StereoModel model = camera_of(photograph);
  MarkLearner learner("thing", {160 * unit, 120 * unit}, none);
  Result<void> fed;
  for (int frame = 0; fed && !learner.done(); ++frame) {
    const cv::Mat1b grey = row(frame % 2 == 0 ? 0 : apart / 2);
    StereoSight sight(grey, grey, model);
    fed = learner.feed(sight);
  }
  ASSERT_FALSE(fed);
  EXPECT_EQ(fed.error().symbol, "ambiguous");
}

constexpr auto width_of = [](const auto& size) { return fmt::format("Width{}", size.param.width); };
INSTANTIATE_TEST_SUITE_P(Sizes, HandHeld, testing::Values(cv::Size(320, 240), cv::Size(640, 480), cv::Size(1280, 960)),
                         width_of);
INSTANTIATE_TEST_SUITE_P(Sizes, Twins, testing::Values(cv::Size(320, 240), cv::Size(640, 480)), width_of);

}  // namespace
}  // namespace pizarra::vision
