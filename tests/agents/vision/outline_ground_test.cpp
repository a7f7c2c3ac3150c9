// How uneven the ground beside a registered outline is, and whether light or a cover makes it so.

#include "agents/vision/marks/outline_ground.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

#include "tests/agents/vision/drawn_planes.hpp"

namespace pizarra::vision {
namespace {

OutlineGround ground_of_square(const cv::Mat1b& image, const LearnedSample& sample) {
  const std::optional<Registered> seen = registered(image, sample);
  if (!seen) return {};
  return look_at_ground(look_at(image, {0, 0, image.cols, image.rows}, noise_of(image)), sample.plane, seen->fit);
}

TEST(OutlineGround, InAShadowIsUnevenByLight) {
  Random random(14);
  const LearnedSample sample = learned(square, random);
  for (const double left : {0.35, 0.5, 0.65}) {
    cv::Mat1b image = filled(projected(square, turned_about({0, 0, 0.3}), {10, 5, 500}), random, 2);
    cv::Mat1b dark = image.colRange(0, 335);
    dark = dark * left;
    const OutlineGround ground = ground_of_square(image, sample);
    EXPECT_GT(ground.doubt, 1) << left;
    EXPECT_GT(ground.light, 0.9) << left;
  }
}

// Both of its edges cross the mark, aslant, so that some of the print is in another light than the ground beside it.
TEST(OutlineGround, UnderASlimShadowIsUnevenByLight) {
  Random random(17);
  const LearnedSample sample = learned(square, random);
  for (const double direction : {0.6, 0.8, 1.0, 1.2}) {
    cv::Mat1b image = filled(projected(square, turned_about({0, 0, 0.3}), {0, 0, 500}), random, 2);
    for (int y = 0; y < image.rows; ++y) {
      for (int x = 0; x < image.cols; ++x) {
        const double along = (x - 319.5) * std::cos(direction) + (y - 239.5) * std::sin(direction);
        if (std::abs(along - 14) < 10) image(y, x) = cv::saturate_cast<std::uint8_t>(0.5 * image(y, x));
      }
    }
    EXPECT_GT(ground_of_square(image, sample).light, 0.9) << direction;
  }
}

// A part of it is as light as the mark's own ground.
TEST(OutlineGround, BesideWhatHidesASideInTwoGreysIsUnevenByMoreThanLight) {
  Random random(18);
  const LearnedSample sample = learned(square, random);
  for (const int level : {60, 100, 140}) {
    cv::Mat1b image = filled(projected(square, cv::Matx33d::eye(), {0, 0, 500}), random, 2);
    image.colRange(330, 420) = level;
    image(cv::Rect(330, 180, 90, 65)) = 200;
    EXPECT_LT(ground_of_square(image, sample).light, 0.1) << level;
  }
}

// The part that stays visible looks like a square that is turned away.
TEST(OutlineGround, BesideWhatHidesASideIsUnevenByMoreThanLight) {
  Random random(15);
  const LearnedSample sample = learned(square, random);
  for (const double level : {70, 100, 130, 160}) {
    cv::Mat1b image = filled(projected(square, cv::Matx33d::eye(), {0, 0, 500}), random, 2);
    image.colRange(330, 420) = level;
    const OutlineGround ground = ground_of_square(image, sample);
    EXPECT_GT(ground.doubt, 1) << level;
    EXPECT_LT(ground.light, 0.1) << level;
  }
}

// Motion widens two of its edges, and darkens the ground beside them.
TEST(OutlineGround, OfAMarkThatMovesIsEven) {
  Random random(16);
  const LearnedSample sample = learned(square, random);
  for (const int motion_px : {5, 9}) {
    cv::Mat1b image = filled(projected(square, turned_about({0, 0, 0.1}), {0, 0, 500}), random);
    cv::blur(image, image, {motion_px, 1});
    EXPECT_LT(ground_of_square(image, sample).doubt, 0.6) << motion_px;
  }
}

}  // namespace
}  // namespace pizarra::vision
