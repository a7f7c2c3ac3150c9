// Where a tag is and how it lies, by its four corners.

#include "agents/vision/sight/tag_pose.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include "tests/agents/vision/drawn_planes.hpp"

namespace pizarra::vision {
namespace {

// Where no corner says anything of a tilt; about the axis of the camera too, which a lab's camera looks along.
TEST(TagPose, IsKnownOfATagThatFacesTheCamera) {
  const camera::StereoModel model = one_camera();
  constexpr double half_px = 24;
  for (const double off_px : {0.0, 0.001, 0.5, 100.0}) {
    const cv::Point2d middle(model.centre_x_px + off_px, model.centre_y_px);
    std::array<cv::Point2f, 4> corners;
    for (std::size_t i = 0; i < 4; ++i) corners[i] = middle + square[i] * (half_px / half_mm);
    const std::optional<TagPose> pose = tag_pose(model, corners, 2 * half_mm);
    ASSERT_TRUE(pose) << off_px << " px beside the axis";
    EXPECT_NEAR(pose->middle_mm[0], off_px * half_mm / half_px, 0.01);
    EXPECT_NEAR(pose->middle_mm[1], 0, 0.01);
    EXPECT_NEAR(pose->middle_mm[2], model.focal_px * half_mm / half_px, 0.01);
    EXPECT_LT(cv::norm(pose->turn - cv::Matx33d::eye()), 0.01);
  }
}

// From any side, near enough to show perspective and so far away that there is hardly any.
TEST(TagPose, IsRightHoweverTheTagLies) {
  const camera::StereoModel model = one_camera();
  Random random(11);
  for (int i = 0; i < 300; ++i) {
    const double tilt = random.uniform(-1, 1);
    const double along = random.uniform(-3.1, 3.1);
    const cv::Vec3d place(random.uniform(-60, 60), random.uniform(-60, 60), random.uniform(150, 900));
    const cv::Matx33d turn = turned_about(tilt * cv::Vec3d(std::cos(along), std::sin(along), 0)) *
                             turned_about({0, 0, random.uniform(-3, 3)});
    const Corners seen = projected(square, turn, place);
    std::array<cv::Point2f, 4> corners;
    std::ranges::copy(seen, corners.begin());
    const std::optional<TagPose> pose = tag_pose(model, corners, 2 * half_mm);
    ASSERT_TRUE(pose) << i;
    EXPECT_LT(cv::norm(pose->middle_mm - place), 0.01 * place[2]) << i;
    const double range = cv::norm(place);
    EXPECT_NEAR(cv::norm(pose->middle_mm), range, 0.1 + range / 1000) << i;
  }
}

// How often a tag's normal is told within two spreads, by the pose or by its other tilt.
struct Coverage {
  int told = 0;
  int within = 0;

  void count(const TagPose& pose, const cv::Matx33d& truth) {
    const auto off = [&](const cv::Matx33d& turn) {
      return std::acos(std::min(1.0, turn(0, 2) * truth(0, 2) + turn(1, 2) * truth(1, 2) + turn(2, 2) * truth(2, 2)));
    };
    const double spread = std::sqrt(pose.covariance(3, 3) + pose.covariance(4, 4));
    const bool has_other = pose.share_of_other > 0.01;
    const double least = has_other ? std::min(off(pose.turn), off(pose.other_turn)) : off(pose.turn);
    ++told;
    within += least < 2 * spread ? 1 : 0;
  }
  double share() const { return told > 0 ? static_cast<double>(within) / told : 0; }
};

class TagCoverage {
 public:
  explicit TagCoverage(std::uint64_t seed) : random_(seed) { pair_.base_line_mm = 60; }

  void look(double depth_mm, double tilt_deg) {
    const double along = random_.uniform(-3.1, 3.1);
    const cv::Vec3d place(random_.uniform(-60, 60), random_.uniform(-60, 60), depth_mm);
    const cv::Matx33d turn = turned_about(tilt_deg * CV_PI / 180 * cv::Vec3d(std::cos(along), std::sin(along), 0)) *
                             turned_about({0, 0, random_.uniform(-3, 3)});
    const SquareCorners left = seen_from(place, turn);
    const SquareCorners right = seen_from(place - cv::Vec3d(pair_.base_line_mm, 0, 0), turn);
    if (const auto pose = tag_pose(one_, left, 2 * half_mm)) by_one.count(*pose, turn);
    if (const auto pose = tag_pose(pair_, left, 2 * half_mm, &right)) by_pair.count(*pose, turn);
  }

  Coverage by_one;
  Coverage by_pair;

 private:
  SquareCorners seen_from(const cv::Vec3d& place, const cv::Matx33d& turn) {
    constexpr double noise_px = 0.15;
    SquareCorners out;
    std::ranges::copy(projected(square, turn, place), out.begin());
    for (cv::Point2f& corner : out) corner += cv::Point2f(noise_px * random_.normal(), noise_px * random_.normal());
    return out;
  }

  const camera::StereoModel one_ = one_camera();
  camera::StereoModel pair_ = one_camera();
  Random random_;
};

// Of a far tag that faces the camera a small tilt's errors are no longer those of a normal distribution.
TEST(TagPose, OrItsOtherTiltIsWithinTwoSpreadsOfTheTruth) {
  for (const double depth_mm : {300.0, 600.0, 900.0}) {
    for (const double tilt_deg : {5.0, 15.0, 30.0, 45.0}) {
      TagCoverage coverage(5);
      for (int i = 0; i < 400; ++i) coverage.look(depth_mm, tilt_deg);
      const bool is_far_and_frontal = depth_mm > 300 && tilt_deg < 10;
      EXPECT_GT(coverage.by_one.share(), is_far_and_frontal ? 0.8 : 0.94) << depth_mm << " mm, " << tilt_deg;
      EXPECT_GT(coverage.by_pair.share(), is_far_and_frontal ? 0.85 : 0.94) << depth_mm << " mm, " << tilt_deg;
    }
  }
}

}  // namespace
}  // namespace pizarra::vision
