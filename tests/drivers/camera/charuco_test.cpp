// ChArUco boards, as OpenCV itself draws them, before cameras with known lenses.

#include "drivers/camera/charuco.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <opencv2/aruco/charuco.hpp>

#include "drivers/camera/board_coverage.hpp"
#include "drivers/camera/stereo_geometry.hpp"
#include "tests/drivers/camera/board_scene.hpp"

namespace pizarra::camera {
namespace {

constexpr int square_px = 100;

CalibrationBoard charuco_board() {
  CalibrationBoard out;
  out.tags.emplace();
  return out;
}

BoardScene scene_with(const CalibrationBoard& board, int dictionary) {
  BoardScene out{.board = board};
  const auto drawn = cv::aruco::CharucoBoard::create(
      board.columns + 1, board.rows + 1, static_cast<float>(board.square_mm), static_cast<float>(board.tags->side_mm),
      cv::aruco::getPredefinedDictionary(dictionary));
  cv::Mat picture;
  drawn->draw({(board.columns + 1) * square_px, (board.rows + 1) * square_px}, picture);
  out.picture = picture;
  return out;
}

const BoardScene& charuco_scene() {
  static const BoardScene drawn = scene_with(charuco_board(), cv::aruco::DICT_4X4_50);
  return drawn;
}

// So that a third of the board or more is beyond the image, on another side each time.
std::vector<cv::Affine3d> poses_beyond() {
  std::vector<cv::Affine3d> out;
  const cv::Vec3d turns[] = {{0.35, 0, 0}, {-0.35, 0.1, 0.1}, {0, 0.4, -0.1}, {0.1, -0.4, 0.05}, {0.3, 0.3, 0.2}};
  const cv::Vec3d places[] = {{-240, -142, 280}, {40, -142, 290}, {-240, 18, 290}, {40, 18, 280},
                              {-100, -172, 270}, {-100, 48, 280}, {-260, -62, 300}};
  int turn = 0;
  for (const cv::Vec3d& place : places) {
    for (int i = 0; i < 2; ++i) out.emplace_back(turns[turn++ % 5], place);
  }
  return out;
}

std::vector<BoardView> charuco_views(const std::vector<cv::Affine3d>& poses, bool single) {
  std::vector<BoardView> out;
  for (const cv::Affine3d& pose : poses) {
    const cv::Mat right = single ? cv::Mat() : cv::Mat(charuco_scene().draw(pose, true));
    const Result<BoardView> view = find_board(charuco_scene().draw(pose, false), right, charuco_scene().board);
    EXPECT_TRUE(view) << view.error().sentence;
    if (view) out.push_back(*view);
  }
  return out;
}

std::size_t corners_in(const std::vector<BoardView>& views) {
  std::size_t out = 0;
  for (const BoardView& view : views) out += view.left.size();
  return out;
}

void expect_left_camera(const StereoCalibration& c, double distortion_within) {
  EXPECT_LT(std::abs(c.left.focal_x_px - charuco_scene().left(0, 0)), 4 * c.deviations.focal_px);
  EXPECT_LT(std::abs(c.left.focal_y_px - charuco_scene().left(1, 1)), 4 * c.deviations.focal_px);
  EXPECT_LT(std::abs(c.left.centre_x_px - charuco_scene().left(0, 2)), 4 * c.deviations.centre_px);
  EXPECT_LT(c.deviations.focal_px, 2);
  EXPECT_NEAR(c.left.distortion[0], charuco_scene().distortion(0), distortion_within);
}

TEST(Charuco, ThePairThatDrewTheBoardsIsFound) {
  const std::vector<BoardView> views = charuco_views(board_poses(), false);
  ASSERT_EQ(views.size(), board_poses().size());
  const Result<CalibratedPair> pair = calibrate_pair(views, charuco_scene().size, charuco_scene().board);
  ASSERT_TRUE(pair) << pair.error().sentence;
  const StereoCalibration& c = pair->calibration;
  expect_left_camera(c, 0.02);
  EXPECT_LT(std::abs(c.right.focal_x_px - charuco_scene().right(0, 0)), 4 * c.deviations.focal_px);
  EXPECT_NEAR(c.translation_mm[0], charuco_scene().between.translation()[0], 0.5);
  EXPECT_LT(c.reprojection_px, 0.4) << "of squares 13 px wide where they are farthest";
  EXPECT_TRUE(pair->left_out.empty());
}

TEST(Charuco, PartsOfTheBoardAreEnough) {
  const std::vector<BoardView> views = charuco_views(poses_beyond(), true);
  ASSERT_EQ(views.size(), poses_beyond().size());
  EXPECT_LT(corners_in(views), views.size() * 54 * 2 / 3) << "much of the boards is beyond the images";
  const Result<CalibratedPair> found = calibrate_single(views, charuco_scene().size, charuco_scene().board);
  ASSERT_TRUE(found) << found.error().sentence;
  expect_left_camera(found->calibration, 0.03);
}

TEST(Charuco, ACornerIsTheSameInWhateverImageItIsSeen) {
  const std::vector<BoardView> views = charuco_views({board_poses()[0], poses_beyond()[0]}, true);
  ASSERT_EQ(views.size(), 2U);
  for (const BoardView& view : views) {
    ASSERT_EQ(view.which.size(), view.left.size());
    EXPECT_TRUE(std::ranges::is_sorted(view.which));
    const std::vector<cv::Point3f> corners = corners_of(view, charuco_scene().board);
    ASSERT_EQ(corners.size(), view.left.size());
  }
  EXPECT_EQ(views[0].left.size(), 54U);
  EXPECT_LT(views[1].left.size(), 54U);
}

TEST(Charuco, WithPartsOfABoardItIsToldWhatIsMissing) {
  const std::vector<BoardView> views = charuco_views(board_poses(), true);
  EXPECT_TRUE(lacks_of(views, charuco_scene().size, charuco_scene().board).size() < 9);
  const std::vector<BoardView> few(views.begin(), views.begin() + 1);
  EXPECT_GT(lacks_of(few, charuco_scene().size, charuco_scene().board).size(), 1U);
}

std::string refused(const cv::Mat& left, const cv::Mat& right) {
  const Result<BoardView> view = find_board(left, right, charuco_scene().board);
  return view ? "found" : view.error().symbol + ": " + view.error().sentence;
}

TEST(Charuco, AnotherBoardIsRefused) {
  const cv::Affine3d pose = board_poses()[0];
  const cv::Mat1b good = charuco_scene().draw(pose, false);
  const cv::Mat1b nothing(charuco_scene().size, std::uint8_t{120});
  EXPECT_EQ(refused(nothing, {}), "no-board: no ChArUco board: there is no tag of aruco-4x4-50 with a number below 35");
  EXPECT_EQ(refused(good, nothing),
            "no-board: no ChArUco board in the right image: there is no tag of aruco-4x4-50 with a number below 35");
  const BoardScene chessboard;
  EXPECT_EQ(refused(chessboard.draw(pose, false), {}), refused(nothing, {}));
  const BoardScene other = scene_with(charuco_board(), cv::aruco::DICT_6X6_250);
  EXPECT_EQ(refused(other.draw(pose, false), {}), refused(nothing, {}));
}

TEST(Charuco, OtherTagsOfItsFamilyMayLieAbout) {
  cv::Mat1b image = charuco_scene().draw(board_poses()[0], false);
  cv::Mat tag;
  cv::aruco::getPredefinedDictionary(cv::aruco::DICT_4X4_50)->drawMarker(45, 48, tag);
  image(cv::Rect(10, 10, 72, 72)).setTo(215);
  tag.copyTo(image(cv::Rect(22, 22, 48, 48)));
  const Result<BoardView> view = find_board(image, {}, charuco_scene().board);
  ASSERT_TRUE(view) << view.error().sentence;
  EXPECT_EQ(view->left.size(), 54U);
  cv::Mat1b alone(image.size(), std::uint8_t{120});
  image(cv::Rect(0, 0, 90, 90)).copyTo(alone(cv::Rect(0, 0, 90, 90)));
  EXPECT_EQ(refused(alone, {}), "no-board: no ChArUco board: there is no tag of aruco-4x4-50 with a number below 35");
}

TEST(Charuco, TooSmallAPartIsRefused) {
  const cv::Mat1b whole = charuco_scene().draw(board_poses()[0], false);
  const BoardView view = find_board(whole, {}, charuco_scene().board).value();
  // All but one row of the board is hidden.
  cv::Mat1b hidden = whole.clone();
  const int below = cvRound(view.left[charuco_scene().board.columns * 4UL].y);
  hidden.rowRange(0, std::max(below, 1)).setTo(120);
  EXPECT_NE(refused(hidden, {}), "found");
  EXPECT_NE(refused(hidden, {}).find("where 8 in two rows are the least"), std::string::npos) << refused(hidden, {});
}

}  // namespace
}  // namespace pizarra::camera
