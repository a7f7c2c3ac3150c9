#include "tests/bench/vision/scene.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

namespace pizarra::bench {
namespace {

// How much darker than the ground a clean image is in all, and where.
struct Darkness {
  double sum = 0;
  cv::Point2d centre;
};

Darkness darkness_of(const cv::Mat1f& image, double ground) {
  Darkness out;
  for (int y = 0; y < image.rows; ++y) {
    for (int x = 0; x < image.cols; ++x) {
      const double dark = ground - image(y, x);
      out.sum += dark;
      out.centre += dark * cv::Point2d(x, y);
    }
  }
  out.centre /= out.sum;
  return out;
}

TEST(VisionScene, MarksCoverTheirAreaAroundTheirCentroidAtAnyPlaceAndTurn) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const std::vector<std::pair<std::string, double>> areas = {
        {"square", 44 * 44}, {"triangle", 44 * 37 / 2.0}, {"cross", 44 * 44 * 5 / 9.0}};
    for (const auto& [name, area] : areas) {
      const cv::Point2d centre(random.uniform(30, 50), random.uniform(30, 50));
      const double scale = random.uniform(0.3, 0.8);
      cv::Mat1f image(80, 80, 100.F);
      paint(image, placed(mark_shape(name), centre, scale, random.uniform(0, 360)), 0);
      const Darkness dark = darkness_of(image, 100);
      EXPECT_NEAR(dark.sum / 100, area * scale * scale, 0.01 * area * scale * scale) << name;
      EXPECT_LT(cv::norm(dark.centre - centre), 0.01) << name;
    }
  }
}

TEST(VisionScene, AHoleIsNotFilled) {
  cv::Mat1f image(40, 40, 100.F);
  Shape ring = disc(10);
  Outline hole = disc(5).front();
  std::ranges::reverse(hole);
  ring.push_back(hole);
  paint(image, placed(ring, {20, 20}, 1, 0), 0);
  EXPECT_NEAR(image(20, 20), 100, 0.001);
  EXPECT_NEAR(darkness_of(image, 100).sum / 100, CV_PI * 75, 1);
}

TEST(VisionScene, WhatLeavesTheImageIsCutOff) {
  cv::Mat1f image(20, 20, 100.F);
  paint(image, placed(box(10, 10), {-0.5, 19.5}, 1, 0), 0);
  EXPECT_NEAR(darkness_of(image, 100).sum / 100, 25, 0.01);
  paint(image, placed(box(10, 10), {-50, 90}, 1, 0), 0);
  EXPECT_NEAR(darkness_of(image, 100).sum / 100, 25, 0.01);
}

TEST(VisionScene, TheSameSeedDrawsTheSameImageAndAnotherAnother) {
  const auto drawn = [](std::uint64_t seed) {
    Random random(seed);
    const Scene scene = random_scene(hard_ranges, random);
    return draw(scene, Side::right, random);
  };
  EXPECT_EQ(cv::norm(drawn(3), drawn(3), cv::NORM_L1), 0);
  EXPECT_GT(cv::norm(drawn(3), drawn(4), cv::NORM_L1), 0);
}

TEST(VisionScene, EverySeedHasACameraAndANoiseOfItsOwnAndNoneTheCells) {
  Scene scene;
  scene.marks = {{.name = "circle", .centre = {160, 120}, .depth_mm = 600}};
  std::vector<cv::Mat1b> images;
  std::vector<double> focals;
  for (const std::uint64_t seed : {5, 6, 5}) {
    set_scene_seed(seed);
    Random random(1);
    images.push_back(draw(scene, Side::left, random));
    focals.push_back(scene_camera().focal_px);
    EXPECT_NE(focals.back(), camera::StereoModel().focal_px);
    EXPECT_NE(scene_camera().base_line_mm, camera::StereoModel().base_line_mm);
  }
  set_scene_seed(1);
  EXPECT_EQ(cv::norm(images[0], images[2], cv::NORM_L1), 0);
  EXPECT_GT(cv::norm(images[0], images[1], cv::NORM_L1), 0);
  EXPECT_NE(focals[0], focals[1]);
}

TEST(VisionScene, TheRightImageShowsAMarkByItsDisparityFurtherLeft) {
  Scene scene;
  scene.marks = {{.name = "circle", .centre = {200.3, 100.7}, .depth_mm = 600}};
  scene.noise = 0;
  Random random(1);
  const double ground = scene.ground_level;
  const cv::Point2d left = darkness_of(draw(scene, Side::left, random), ground).centre;
  const cv::Point2d right = darkness_of(draw(scene, Side::right, random), ground).centre;
  const camera::StereoModel& camera = scene_camera();
  EXPECT_NEAR(left.x - right.x, camera.focal_px * camera.base_line_mm / 600, 0.03);
  EXPECT_NEAR(left.y, right.y, 0.03);
  EXPECT_NEAR(left.x, 200.3, 0.03);
}

TEST(VisionScene, RandomMarksStayWithinBothImagesAndApart) {
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Scene scene = random_scene(hard_ranges, random);
    for (const SceneMark& mark : scene.marks) {
      const double reach = 31 * scale_at(mark.depth_mm);
      EXPECT_GT(mark.centre.x - disparity_px(mark.depth_mm), reach);
      EXPECT_LT(mark.centre.x, 320 - reach);
      EXPECT_GT(mark.centre.y, reach);
      EXPECT_LT(mark.centre.y, 240 - reach);
      EXPECT_TRUE(std::ranges::none_of(scene.marks, [&](const SceneMark& other) {
        return &other != &mark && cv::norm(other.centre - mark.centre) < reach;
      }));
    }
  }
}

}  // namespace
}  // namespace pizarra::bench
