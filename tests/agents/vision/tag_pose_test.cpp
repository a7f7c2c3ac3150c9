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

}  // namespace
}  // namespace pizarra::vision
