// A pair of cameras of one's own, or one of them, calibrated from the shell.

#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <regex>

#include "tests/drivers/camera/board_scene.hpp"
#include "tests/programs/camera_cell.hpp"
#include "tests/programs/running.hpp"

namespace pizarra::programs {
namespace {

class OwnPair : public testing::Test {
 protected:
  // Drawn once, for they take a second.
  static void SetUpTestSuite() {
    const camera::BoardScene scene;
    int number = 10;
    for (const cv::Affine3d& pose : camera::board_poses()) {
      cv::imwrite(scratch_folder() + fmt::format("left{}.png", number), scene.draw(pose, false));
      cv::imwrite(scratch_folder() + fmt::format("right{}.png", number), scene.draw(pose, true));
      ++number;
    }
  }
};

TEST_F(OwnPair, IsCalibratedFromFilesAndTheFileIsTheCells) {
  const Said said = run_cell("calibrate 'left*.png' 'right*.png'");
  ASSERT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "left10.png right10.png: board found")) << said.text;
  EXPECT_TRUE(contains(said, "14 pairs of 480 x 360")) << said.text;
  const std::string cell = cell_with(
      "pair", "(pair (images \"left*.png\") (images \"right*.png\")) (rate 60) (calibration \"pair.calibration\")");
  const Said seen =
      run_cell("repl " + cell + " --agents vision --eval '(vision (connect))'" +
               " --eval '(vision (learn 5 5 \"corner\"))' --eval '(ask (camera-model vision ?w ?h ?f ?cx ?cy ?b))'");
  EXPECT_TRUE(contains(seen, "?w = 480")) << seen.text;
}

TEST_F(OwnPair, OneCameraAloneIsCalibratedToo) {
  const Said said = run_cell("calibrate 'left*.png'");
  ASSERT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "left10.png: board found")) << said.text;
  EXPECT_TRUE(contains(said, "14 images of 480 x 360")) << said.text;
  EXPECT_TRUE(contains(said, "reprojection error 0.")) << said.text;
  const std::string camera = "(single (images \"left*.png\")) (rate 60)";
  const std::string cell = cell_with("one", camera + " (calibration \"camera.calibration\")");
  const Said seen =
      run_cell("repl " + cell + " --agents vision --eval '(vision (connect))'" +
               " --eval '(vision (learn 5 5 \"corner\"))' --eval '(ask (camera-model vision ?w ?h ?f ?cx ?cy 0.0))'");
  EXPECT_TRUE(contains(seen, "?w = 480")) << seen.text;
  EXPECT_FALSE(contains(seen, "?f = 417.6")) << "0.87 of the width is a guess: " << seen.text;
  const Said live = run_cell("calibrate --json --out one.calibration --cell " + cell_with("live-one", camera));
  EXPECT_EQ(live.status, 0) << live.text;
  EXPECT_TRUE(contains(live, "\"images\":14")) << live.text;
}

// Names are whatever bytes a file system takes, and none of them reaches the terminal as it is.
TEST_F(OwnPair, WhoseNamesAreNoTextIsToldByWhatCanBeShownOfThem) {
  const std::string folder = scratch_folder() + "f\xFCr\x1b[31m/";
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "\x1b]0;1\xFF.png") << "this is no picture";
  const Said said = run_cell("calibrate '" + folder + "' --out 'f\xFCr.calibration'");
  EXPECT_EQ(said.status, 1) << said.text;
  EXPECT_TRUE(contains(said, "\\x1b]0;1\\xff.png")) << said.text;
  EXPECT_FALSE(contains(said, "\x1b")) << said.text;
  const Said nowhere = run_cell("calibrate 'n\xFC\x1b[31m*.png' --json");
  EXPECT_TRUE(contains(nowhere, "n\\\\xfc")) << nowhere.text;
  EXPECT_FALSE(contains(nowhere, "\x1b")) << nowhere.text;
  for (const char* words : {"check ", "look --png x.png --board ", "scenario ", "look "}) {
    const Said no_such = run_cell(words + std::string("'f\xFC\x1b[31m'"));
    EXPECT_GT(no_such.status, 0) << no_such.text;
    EXPECT_LT(no_such.status, 128) << words << no_such.text;
    EXPECT_FALSE(contains(no_such, "\x1b")) << words << no_such.text;
    EXPECT_FALSE(contains(no_such, "\xFC")) << words << no_such.text;
  }
}

TEST_F(OwnPair, IsCalibratedThroughItsOwnCameras) {
  const std::string cell =
      cell_with("live", "(pair (images \"left*.png\") (images \"right*.png\")) (focal 400) (base-line 80)");
  const Said said = run_cell("calibrate --json --out live.calibration --cell " + cell);
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "\"pairs\":14")) << said.text;
}

TEST_F(OwnPair, TellsABoardHowItIsCalibrated) {
  const std::string cell =
      cell_with("told", "(pair (images \"left*.png\") (images \"right*.png\")) (focal 400) (base-line 80)");
  const std::string at = "ipc://" + scratch_folder() + "told";
  const Running board({PIZARRA_BOARD, "--listen", at}, scratch_folder() + "told.log");
  ASSERT_TRUE(wait_until([&] { return board.said().contains("ready"); }, std::chrono::seconds(60))) << board.said();
  const Said said = run_cell("calibrate --out told.calibration --cell " + cell + " --tell --board " + at);
  EXPECT_EQ(said.status, 0) << said.text;
  const auto asked = [&](const std::string& query) { return run_cell("ask '" + query + "' --board " + at); };
  const Said state = asked("(calibration ?state ?sentence 480 360 14 20)");
  EXPECT_TRUE(contains(state, "?state = done")) << state.text;
  EXPECT_TRUE(contains(state, "told.calibration written; reprojection error 0.")) << state.text;
  const Said last = asked("(calibration-board 14 ?outlines)");
  EXPECT_TRUE(std::regex_search(last.text, std::regex(R"(\(\((-?\d+ ?){8}\) \((-?\d+ ?){8}\)\))"))) << last.text;
  EXPECT_FALSE(contains(asked("(agent ?name calibrate ?host)"), "?name =")) << "it has left";
}

TEST_F(OwnPair, IsNotCalibratedWhereTheBoardThatIsToBeToldIsNotThere) {
  const std::string cell = cell_with("untold", "(single (images \"left*.png\"))");
  const Said nowhere = run_cell("calibrate --out untold.calibration --cell " + cell + " --tell --board ipc://" +
                                scratch_folder() + "nowhere");
  EXPECT_EQ(nowhere.status, 4) << nowhere.text;
  EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "untold.calibration"));
  EXPECT_EQ(run_cell("calibrate 'left*.png' --tell").status, 2) << "of files nothing is told";
}

// As a cell's camera pairs them: an image that one camera missed shifts nothing.
TEST_F(OwnPair, IsPairedByTheNumbersInItsNames) {
  const Said said = run_cell("calibrate 'left1[0-8].png' 'right1[1-9].png' --out numbered.calibration");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "2 images have no partner")) << said.text;
  EXPECT_TRUE(contains(said, "left11.png right11.png: board found")) << said.text;
  EXPECT_TRUE(contains(said, "8 pairs of 480 x 360")) << said.text;
}

TEST_F(OwnPair, WhoseImagesDoNotBelongTogetherGetsNoFile) {
  const std::string folder = scratch_folder() + "shifted/";
  std::filesystem::create_directory(folder);
  for (int number = 10; number < 19; ++number) {
    std::filesystem::copy_file(scratch_folder() + fmt::format("right{}.png", number + 1),
                               folder + fmt::format("right{}.png", number));
  }
  const Said said = run_cell("calibrate 'left1[0-8].png' shifted --out shifted.calibration");
  EXPECT_EQ(said.status, 1);
  EXPECT_TRUE(contains(said, "Do the images of each pair belong together?")) << said.text;
  EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "shifted.calibration"));
}

// Of one side's pictures, in a folder of their own.
std::string copies_of(const std::string& side, const std::string& folder_name) {
  std::string folder = scratch_folder() + folder_name + "/";
  std::filesystem::create_directory(folder);
  for (int number = 10; number < 24; ++number) {
    const std::string name = fmt::format("{}{}.png", side, number);
    std::filesystem::copy_file(scratch_folder() + name, folder + name);
  }
  return folder;
}

TEST_F(OwnPair, IsCalibratedWithoutThePicturesThatAreOfAnotherSize) {
  const std::string folder = copies_of("left", "mixed");
  // Two that come first, one without a board, and one later.
  cv::imwrite(folder + "left00.png", cv::Mat1b(240, 320, 100));
  const auto make_small = [&](const std::string& from, const std::string& to) {
    cv::Mat small;
    cv::resize(cv::imread(folder + from), small, {}, 0.75, 0.75);
    cv::imwrite(folder + to, small);
  };
  make_small("left11.png", "left01.png");
  make_small("left12.png", "left12.png");
  const Said said = run_cell("calibrate mixed --out mixed.calibration");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "left12.png: left out, 360x270, where most with a board are 480x360")) << said.text;
  EXPECT_TRUE(contains(said, "13 images of 480 x 360")) << said.text;
  EXPECT_TRUE(contains(said, "left01.png: left out, 360x270")) << said.text;
  const Said few = run_cell("calibrate 'left1[0-3].png' 'mixed/left1[0-3].png'");
  EXPECT_EQ(few.status, 1);
  EXPECT_TRUE(contains(few, "left12.png left12.png: images of 480x360 and 360x270")) << few.text;
  EXPECT_TRUE(contains(few, "there are 3")) << few.text;
}

TEST_F(OwnPair, IsCalibratedWithoutThePairThatDoesNotBelong) {
  const std::string folder = copies_of("right", "one-moved");
  cv::Mat moved;
  const cv::Mat by = (cv::Mat1d(2, 3) << 1, 0, 9, 0, 1, 6);
  cv::warpAffine(cv::imread(folder + "right13.png"), moved, by, {}, cv::INTER_LINEAR, cv::BORDER_REPLICATE);
  cv::imwrite(folder + "right13.png", moved);
  const Said said = run_cell("calibrate 'left*.png' one-moved --out without.calibration");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "left13.png right13.png: left out, ")) << said.text;
  EXPECT_TRUE(contains(said, "13 pairs of 480 x 360")) << said.text;
  const Said twice = run_cell("calibrate 'left*.png' 'left*.png' --out twice.calibration");
  EXPECT_EQ(twice.status, 1);
  EXPECT_TRUE(contains(twice, "both are the same camera's images")) << twice.text;
}

TEST_F(OwnPair, WhoseCornersNobodyCanTellGetsNoFile) {
  const std::string folder = scratch_folder() + "middle/";
  std::filesystem::create_directory(folder);
  const camera::BoardScene scene;
  int number = 10;
  for (const cv::Vec3d& turn : {cv::Vec3d(0.6, 0, 0), cv::Vec3d(-0.6, 0.1, 0), cv::Vec3d(0, 0.6, 0.1),
                                cv::Vec3d(0.1, -0.6, 0), cv::Vec3d(0.4, 0.4, 0), cv::Vec3d(-0.4, -0.4, 0)}) {
    cv::imwrite(fmt::format("{}{}.png", folder, number++), scene.draw({turn, cv::Vec3d(-90, -50, 900)}, false));
  }
  const Said said = run_cell("calibrate middle --out middle.calibration");
  EXPECT_EQ(said.status, 1) << said.text;
  EXPECT_TRUE(contains(said, "near the image's corners too")) << said.text;
  EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "middle.calibration"));
}

// Copies of one pair, and of one camera's image.
std::string repeated(const std::string& name, int times) {
  std::string folder = scratch_folder() + name + "-repeated/";
  std::filesystem::create_directory(folder);
  for (int i = 0; i < times; ++i) {
    std::filesystem::copy_file(scratch_folder() + name, fmt::format("{}{:02}.png", folder, i));
  }
  return folder;
}

TEST_F(OwnPair, CountsThePicturesOfOnePlaceOnce) {
  const Said said = run_cell("calibrate " + repeated("left13.png", 8) + " " + repeated("right13.png", 8) +
                             " --out repeated.calibration");
  EXPECT_EQ(said.status, 1) << said.text;
  EXPECT_TRUE(contains(said, "05.png 05.png: the board stands as in 00.png 00.png")) << said.text;
  EXPECT_TRUE(contains(said, "at least 5 pairs")) << said.text;
  EXPECT_TRUE(contains(said, "there are 1")) << said.text;
  EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "repeated.calibration"));
}

TEST_F(OwnPair, ThatOneCameraSeesIsTakenAsTheBoardMovesUntilThereIsEnough) {
  const Said said = run_cell("calibrate --pairs 9 --out nine.calibration --cell " +
                             cell_with("nine", "(single (images \"left*.png\"))"));
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "image 9: board found, 9 of 9")) << said.text;
  EXPECT_TRUE(contains(said, "fitting the camera to 9 boards ...")) << said.text;
  EXPECT_TRUE(contains(said, "9 images of 480 x 360")) << said.text;
  const Said still =
      run_cell("calibrate --cell " + cell_with("still", "(single (images \"" + repeated("left12.png", 4) + "\"))"));
  EXPECT_EQ(still.status, 1) << still.text;
  EXPECT_TRUE(contains(still, "image 4: the board stands as in image 1")) << still.text;
  EXPECT_TRUE(contains(still, "at least 5 images")) << still.text;
}

TEST_F(OwnPair, WhoseBoardIsNowhereIsToldSoAtOnce) {
  const std::string folder = scratch_folder() + "blank/";
  std::filesystem::create_directory(folder);
  for (int i = 0; i < 3; ++i) cv::imwrite(fmt::format("{}{}.png", folder, i), cv::Mat1b(360, 480, 100));
  const Said said = run_cell("calibrate --cell " + cell_with("blank", "(single (images \"" + folder + "\"))"));
  EXPECT_EQ(said.status, 1) << said.text;
  EXPECT_TRUE(contains(said, "image 1: no board of 9 x 6 inner corners")) << said.text;
  EXPECT_TRUE(contains(said, "image 3: no board of 9 x 6 inner corners")) << said.text;
}

// The board at all its places, and then at rest for minutes.
std::string resting_folder() {
  std::string folder = copies_of("left", "resting");
  for (int i = 0; i < 3000; ++i) {
    std::filesystem::create_hard_link(folder + "left10.png", fmt::format("{}rest{:04}.png", folder, i));
  }
  return folder;
}

TEST_F(OwnPair, IsCalibratedByWhatCameUntilCtrlC) {
  const std::string folder = resting_folder();
  const std::string all = cell_with("resting", "(single (images \"" + folder + "\"))");
  Running enough({PIZARRA_CELL, "calibrate", "--cell", all, "--out", scratch_folder() + "stopped.calibration"},
                 scratch_folder() + "enough.log");
  ASSERT_TRUE(wait_until([&] { return enough.said().contains("board found, 14 of 20"); }, std::chrono::seconds(60)));
  enough.signal(SIGINT);
  EXPECT_EQ(enough.end(std::chrono::seconds(60)), 0) << enough.said();
  EXPECT_TRUE(enough.said().contains("14 images of 480 x 360")) << enough.said();

  const std::string rest = cell_with("rest", "(single (images \"" + folder + "rest*.png\"))");
  Running few({PIZARRA_CELL, "calibrate", "--cell", rest, "--out", scratch_folder() + "few.calibration"},
              scratch_folder() + "few.log");
  ASSERT_TRUE(
      wait_until([&] { return few.said().contains("the board stands as in image 1"); }, std::chrono::seconds(60)));
  few.signal(SIGINT);
  EXPECT_EQ(few.end(std::chrono::seconds(60)), 130) << few.said();
  EXPECT_TRUE(few.said().contains("at least 5 images")) << few.said();
  EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "few.calibration"));
}

TEST_F(OwnPair, WhoseCameraGoesAwayIsToldSo) {
  const std::string film = scratch_folder() + "gone.avi";
  cv::VideoWriter writer(film, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), 25, {480, 360});
  for (int i = 0; i < 6; ++i) writer.write(cv::Mat3b(360, 480, cv::Vec3b(90, 90, 90)));
  writer.release();
  const std::string cell = cell_with("gone", "(single (stream \"file://" + film + "\"))");
  const Said said = run_cell("calibrate --cell " + cell);
  EXPECT_EQ(said.status, 4) << said.text;
  EXPECT_TRUE(contains(said, "the camera: file://" + film + " gives no images")) << said.text;
  EXPECT_FALSE(contains(said, "pairs")) << said.text;
}

TEST_F(OwnPair, ThatCannotBeCalibratedIsToldWhy) {
  const Said unpaired = run_cell("calibrate 'left1[0-5].png' 'right1[4-9].png'");
  EXPECT_EQ(unpaired.status, 2);
  EXPECT_TRUE(contains(unpaired,
                       "6 images are of the left camera and 6 of the right one, and the numbers in their "
                       "names do not say which belong together, as of left10.png"))
      << unpaired.text;
  const Said few = run_cell("calibrate 'left1[0-3].png' 'right1[0-3].png'");
  EXPECT_EQ(few.status, 1);
  EXPECT_TRUE(contains(few, "there are 4")) << few.text;
  const Said none = run_cell("calibrate --columns 12 'left1[01].png' 'right1[01].png'");
  EXPECT_TRUE(contains(none, "left10.png right10.png: no board of 12 x 6 inner corners in either image")) << none.text;
  EXPECT_EQ(run_cell("calibrate").status, 2);
  const Said nowhere = run_cell("calibrate 'nowhere*.png' 'right*.png'");
  EXPECT_TRUE(contains(nowhere, "there are no images at nowhere*.png")) << nowhere.text;
}

}  // namespace
}  // namespace pizarra::programs
