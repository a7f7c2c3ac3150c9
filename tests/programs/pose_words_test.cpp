// A pose as `find` and `measure` print it.

#include "programs/commands/pose_words.hpp"

#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

namespace pizarra::programs {
namespace {

vision::MarkPose pose_turned_by(double about_x_deg) {
  cv::Matx33d turn;
  cv::Rodrigues(cv::Vec3d(about_x_deg * CV_PI / 180, 0, 0), turn);
  return {{1, -0.001, 500}, turn, Eigen::Matrix<double, 6, 6>::Identity()};
}

TEST(PoseWords, NoZeroIsNegative) {
  const vision::MarkPose pose = pose_turned_by(-0.001);
  EXPECT_EQ(pose_words(pose).find("-0.00"), std::string::npos) << pose_words(pose);
  EXPECT_EQ(pose_json(pose).find("-0.00"), std::string::npos) << pose_json(pose);
}

TEST(PoseWords, TellTheOtherTiltAndHowLikelyItIs) {
  vision::MarkPose pose = pose_turned_by(20);
  EXPECT_EQ(pose_words(pose).find("or, by"), std::string::npos);
  EXPECT_EQ(pose_json(pose).find("flipped"), std::string::npos);
  pose.flipped = vision::MarkPose::Flipped{pose_turned_by(-18).turn, 0.31};
  EXPECT_TRUE(pose_words(pose).ends_with("; or, by 31 %, turned -18.00 0.00 0.00 degrees")) << pose_words(pose);
  EXPECT_TRUE(pose_json(pose).ends_with(R"(,"flipped":{"turn":[-18.00,0.00,0.00],"share":0.310})")) << pose_json(pose);
}

}  // namespace
}  // namespace pizarra::programs
