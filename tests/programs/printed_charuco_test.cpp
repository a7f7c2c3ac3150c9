// A ChArUco board from the shell: printed, seen by a camera, and calibrated with.

#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "drivers/camera/calibration.hpp"
#include "tests/drivers/camera/board_scene.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

Said run(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }

// The printed page's board, as a person holds it before a camera: the page turned by a quarter.
cv::Mat1b printed_board() {
  EXPECT_EQ(run("shapes --charuco --print charuco.png").status, 0);
  const cv::Mat1b page = cv::imread(scratch_folder() + "charuco.png", cv::IMREAD_GRAYSCALE);
  constexpr double dots_a_mm = 300 / 25.4;
  const auto dots = [](double mm) { return cvRound(mm * dots_a_mm); };
  cv::Mat out;
  cv::resize(page(cv::Rect(dots(17.5), dots(16), dots(175), dots(250))), out, {700, 1000}, 0, 0, cv::INTER_AREA);
  cv::rotate(out, out, cv::ROTATE_90_COUNTERCLOCKWISE);
  return out;
}

class PrintedCharuco : public testing::Test {
 protected:
  // Drawn once, for they take a second. In some images a part of the board is beyond the edge.
  static void SetUpTestSuite() {
    camera::BoardScene scene;
    scene.picture = printed_board();
    std::vector<cv::Affine3d> poses = camera::board_poses();
    poses.emplace_back(cv::Vec3d(0.2, 0.2, 0), cv::Vec3d(-240, -142, 290));
    poses.emplace_back(cv::Vec3d(-0.2, 0.1, 0), cv::Vec3d(40, 18, 290));
    for (std::size_t i = 0; i < poses.size(); ++i) {
      cv::imwrite(scratch_folder() + fmt::format("charuco-left{}.png", 10 + i), scene.draw(poses[i], false));
      cv::imwrite(scratch_folder() + fmt::format("charuco-right{}.png", 10 + i), scene.draw(poses[i], true));
    }
    cv::imwrite(scratch_folder() + "chess.png", camera::BoardScene().draw(poses[0], false));
  }
};

TEST_F(PrintedCharuco, OneCameraIsCalibratedWithPartsOfIt) {
  const Said said = run("calibrate 'charuco-left*.png' --charuco --out charuco.calibration");
  ASSERT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "charuco-left24.png: board found")) << said.text;
  EXPECT_TRUE(contains(said, "16 images of 480 x 360")) << said.text;
  const Result<camera::StereoCalibration> found =
      camera::read_calibration_file(scratch_folder() + "charuco.calibration");
  ASSERT_TRUE(found) << found.error().sentence;
  const double truth_px = camera::BoardScene().left(0, 0);
  EXPECT_LT(std::abs(found->left.focal_x_px - truth_px), 4 * found->deviations.focal_px);
  EXPECT_LT(found->deviations.focal_px, 4) << "1 % of it";
}

TEST_F(PrintedCharuco, APairIsCalibrated) {
  const Said said = run("calibrate 'charuco-left*.png' 'charuco-right*.png' --charuco --out charuco-pair.calibration");
  ASSERT_EQ(said.status, 0) << said.text;
  const Result<camera::StereoCalibration> found =
      camera::read_calibration_file(scratch_folder() + "charuco-pair.calibration");
  ASSERT_TRUE(found) << found.error().sentence;
  EXPECT_NEAR(found->translation_mm[0], camera::BoardScene().between.translation()[0], 0.5);
}

TEST_F(PrintedCharuco, AnotherBoardIsRefusedAndNothingIsWritten) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"'charuco-left*.png' --charuco --tags 6x6-50", "no ChArUco board: there is no tag of aruco-6x6-50"},
      {"chess.png --charuco", "no ChArUco board: there is no tag of aruco-4x4-50"},
  };
  for (const auto& [words, sentence] : wrong) {
    const Said said = run("calibrate " + words + " --out refused.calibration");
    EXPECT_EQ(said.status, 1) << words << "\n" << said.text;
    EXPECT_TRUE(contains(said, sentence)) << words << "\n" << said.text;
    EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "refused.calibration")) << words;
  }
}

TEST_F(PrintedCharuco, ABoardThatCannotBeIsRefused) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"--charuco --tag-side 30", "tags of 30 mm do not fit into squares of 25 mm"},
      {"--charuco --tags 16h5", "the board has 35 light squares, and apriltag-16h5 only 30 tags"},
      {"--charuco --tags standard41h12", "a ChArUco board has no tags of apriltag-standard41h12"},
      {"--charuco --tags 4x5", "there is no family of tags 4x5"},
      {"--tags 4x4-50", "--charuco"},
  };
  for (const auto& [words, sentence] : wrong) {
    const Said said = run("calibrate 'charuco-left*.png' " + words);
    EXPECT_EQ(said.status, 2) << words << "\n" << said.text;
    EXPECT_TRUE(contains(said, sentence)) << words << "\n" << said.text;
  }
  EXPECT_EQ(run("shapes --charuco --board --print both.png").status, 2);
}

}  // namespace
}  // namespace pizarra::programs
