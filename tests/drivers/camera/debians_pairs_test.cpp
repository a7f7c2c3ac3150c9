// Debian's package opencv-doc has the pairs of photographs that OpenCV's own manual calibrates with.

#include <cstdio>
#include <filesystem>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "drivers/camera/chessboard.hpp"

namespace pizarra::camera {
namespace {

TEST(DebiansPairs, AreRectifiedToAFractionOfAPixel) {
  const std::string folder = "/usr/share/doc/opencv-doc/examples/data/";
  if (!std::filesystem::exists(folder + "left01.jpg")) GTEST_SKIP() << "opencv-doc is not installed";
  const CalibrationBoard board{9, 6, 25};
  std::vector<BoardView> views;
  cv::Size size;
  for (int i = 1; i <= 14; ++i) {
    const std::string number = (i < 10 ? "0" : "") + std::to_string(i) + ".jpg";
    const cv::Mat left = cv::imread(folder + "left" + number, cv::IMREAD_GRAYSCALE);
    const cv::Mat right = cv::imread(folder + "right" + number, cv::IMREAD_GRAYSCALE);
    if (left.empty() || right.empty()) continue;
    size = left.size();
    const Result<BoardView> view = find_board(left, right, board);
    if (view) views.push_back(*view);
  }
  EXPECT_EQ(views.size(), 13u);
  const Result<CalibratedPair> pair = calibrate_pair(views, size, board);
  ASSERT_TRUE(pair) << pair.error().sentence;
  const StereoCalibration& c = pair->calibration;
  std::printf("reprojection %.3f px, epipolar %.3f px\n", c.reprojection_px, c.epipolar_px);
  EXPECT_TRUE(pair->left_out.empty());
  EXPECT_LT(c.reprojection_px, 0.6);
  EXPECT_LT(c.epipolar_px, 0.4);
  EXPECT_LT(c.deviations.focal_px, 2);
  EXPECT_LT(c.deviations.base_line_mm, 0.3);
}

}  // namespace
}  // namespace pizarra::camera
