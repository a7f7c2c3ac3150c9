#include "drivers/camera/board_coverage.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <opencv2/calib3d.hpp>

#include "tests/drivers/camera/board_scene.hpp"

namespace pizarra::camera {
namespace {

const BoardScene& stage() {
  static const BoardScene drawn;
  return drawn;
}

// Its corners as the cameras see them, whether or not they lie in the image.
BoardView view_of(const cv::Affine3d& pose, bool single) {
  const auto seen = [](const cv::Affine3d& from, const cv::Matx33d& camera) {
    std::vector<cv::Point3d> corners;
    for (const cv::Point3f& corner : corners_of(stage().board)) corners.emplace_back(corner);
    std::vector<cv::Point2d> points;
    cv::projectPoints(corners, from.rvec(), from.translation(), camera, stage().distortion, points);
    return std::vector<cv::Point2f>(points.begin(), points.end());
  };
  BoardView view{.left = seen(pose, stage().left)};
  if (!single) view.right = seen(stage().between * pose, stage().right);
  return view;
}

std::vector<std::string> lacking(const std::vector<BoardView>& views) {
  std::vector<std::string> out;
  for (const Lack& lack : lacks_of(views, stage().size, stage().board)) out.push_back(lack.sentence);
  return out;
}

bool lacks(const std::vector<BoardView>& views, const std::string& words) {
  return std::ranges::any_of(lacking(views), [&](const std::string& one) { return one.contains(words); });
}

TEST(BoardCoverage, OfNoBoardIsThatItIsToBeShown) {
  EXPECT_EQ(lacking({}), std::vector<std::string>{"hold the board before the camera, whole and flat"});
}

TEST(BoardCoverage, OfBoardsAllOverTheImageIsNothing) {
  std::vector<BoardView> views;
  for (const double x : {-230, -100, 30}) {
    for (const double y : {-170, -60, 50}) {
      views.push_back(view_of(cv::Affine3d(cv::Vec3d(0.4, x / 400, 0), cv::Vec3d(x, y, 640)), true));
    }
  }
  EXPECT_EQ(lacking(views), std::vector<std::string>());
}

TEST(BoardCoverage, NamesThePartsThatNoBoardCameTo) {
  const std::vector<BoardView> views = {view_of(cv::Affine3d(cv::Vec3d(0.4, 0, 0), cv::Vec3d(-230, -170, 640)), true),
                                        view_of(cv::Affine3d(cv::Vec3d(-0.4, 0, 0), cv::Vec3d(-230, -170, 640)), true)};
  EXPECT_FALSE(lacks(views, "to the top left of the image"));
  EXPECT_TRUE(lacks(views, "to the bottom right of the image"));
  EXPECT_FALSE(lacks(views, "tilt"));
  const std::vector<Lack> all = lacks_of(views, stage().size, stage().board);
  const auto last = std::ranges::find(all, "bring the board to the bottom right of the image", &Lack::sentence);
  ASSERT_NE(last, all.end());
  ASSERT_TRUE(last->part);
  EXPECT_FALSE(last->part->right_image);
  EXPECT_EQ(last->part->column, 2);
  EXPECT_EQ(last->part->row, 2);
}

TEST(BoardCoverage, AsksForTiltsOfBoardsThatAllFaceTheCamera) {
  std::vector<BoardView> views;
  for (const double x : {-230, -100, 30}) {
    views.push_back(view_of(cv::Affine3d(cv::Vec3d(0, 0, 0.1), cv::Vec3d(x, -60, 640)), true));
  }
  EXPECT_TRUE(lacks(views, "tilt the board"));
  views.push_back(view_of(cv::Affine3d(cv::Vec3d(0, 0.5, 0), cv::Vec3d(-100, -60, 640)), true));
  EXPECT_FALSE(lacks(views, "tilt the board"));
}

// The right camera sees the board farther to the left.
TEST(BoardCoverage, OfAPairAsksForBothImages) {
  const std::vector<BoardView> views = {view_of(cv::Affine3d(cv::Vec3d(0.4, 0, 0), cv::Vec3d(-55, -170, 640)), false)};
  EXPECT_TRUE(lacks(views, "to the left of the left image"));
  EXPECT_FALSE(lacks(views, "to the top right of the left image"));
  EXPECT_TRUE(lacks(views, "to the top right of the right image"));
}

}  // namespace
}  // namespace pizarra::camera
