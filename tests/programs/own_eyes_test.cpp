// A camera of one's own, from the shell: the sheet to print, the cell file, the prompt.

#include <csignal>
#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "tests/agents/vision/photograph.hpp"
#include "tests/programs/camera_cell.hpp"
#include "tests/programs/running.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

std::string folder_of_photographs() {
  std::string folder = scratch_folder() + "photographs/";
  std::filesystem::create_directories(folder);
  Random random(3);
  for (int i = 0; i < 4; ++i) {
    cv::imwrite(fmt::format("{}{}.jpg", folder, i), vision::Photograph{.tilt_deg = 10}.take(random));
  }
  return folder;
}

TEST(OwnEyes, ASheetIsPrintedAtItsRealSize) {
  ASSERT_EQ(run_cell("shapes --print shapes.png").status, 0);
  const std::string bytes = whole_file(scratch_folder() + "shapes.png");
  EXPECT_EQ(bytes.substr(37, 4), "pHYs") << "it says how many dots a metre has";
  const cv::Mat page = cv::imread(scratch_folder() + "shapes.png", cv::IMREAD_GRAYSCALE);
  ASSERT_EQ(page.size(), cv::Size(2480, 3508));
  const double dots_a_mm = 300 / 25.4;
  const auto at = [&](double x_mm, double y_mm) {
    return page.at<std::uint8_t>(cvFloor(y_mm * dots_a_mm), cvFloor(x_mm * dots_a_mm));
  };
  // The circle of 44 mm in its face of 60 mm, around (60, 85).
  EXPECT_EQ(at(60 - 21.8, 85), 0);
  EXPECT_EQ(at(60 - 22.2, 85), 255);
  EXPECT_EQ(at(60, 85 + 21.8), 0);
  EXPECT_EQ(at(60, 85 + 22.2), 255);
  EXPECT_EQ(at(55.2, 284.2), 0) << "the bar begins at 55 mm";
  EXPECT_EQ(at(54.8, 284.2), 255);
  EXPECT_EQ(at(154.8, 284.2), 0) << "and ends at 155 mm";
  EXPECT_EQ(at(155.2, 284.2), 255);
}

TEST(OwnEyes, APdfLeadsToItsParts) {
  ASSERT_EQ(run_cell("shapes --board --print board.pdf").status, 0);
  const std::string pdf = whole_file(scratch_folder() + "board.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-1.4\n"));
  EXPECT_TRUE(pdf.ends_with("%%EOF\n"));
  const std::size_t table = std::stoul(pdf.substr(pdf.rfind("startxref") + 10));
  EXPECT_EQ(pdf.substr(table, 5), "xref\n");
  const std::size_t first = std::stoul(pdf.substr(pdf.find("65535 f \n") + 9, 10));
  EXPECT_EQ(pdf.substr(first, 7), "1 0 obj");
}

TEST(OwnEyes, WhatIsNoSheetOrCannotBeWrittenIsToldSo) {
  const Said unknown = run_cell("shapes --print shapes.doc");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown, "FILE.pdf")) << unknown.text;
  EXPECT_EQ(run_cell("shapes --print /proc/shapes.pdf").status, 4);
}

TEST(OwnEyes, APersonTeachesAndFindsAtThePromptWithPhotographsForACamera) {
  const std::string cell = cell_with("photos", "(single (images \"" + folder_of_photographs() + "\")) (rate 60)");
  const vision::Photograph photograph{.tilt_deg = 10};
  std::string words = "repl " + cell + " --agents vision";
  for (const vision::PrintedShape& shape : vision::printed_shapes()) {
    const cv::Point2d at = photograph.seen_at(shape.name);
    words += fmt::format(" --eval '(vision (learn {:.0f} {:.0f} \"{}\"))'", at.x, at.y, shape.name);
  }
  words += " --eval '(vision (find \"cross\"))'";
  const Said said = run_cell(words);
  EXPECT_EQ(said.status, 0) << said.text;
  for (const vision::PrintedShape& shape : vision::printed_shapes()) {
    EXPECT_TRUE(contains(said, "(LEARN \"" + shape.name + "\" OK)")) << said.text;
  }
  EXPECT_TRUE(contains(said, "(FIND \"cross\" OK (")) << said.text;
}

TEST(OwnEyes, ACameraThatIsNotThereIsNamedAndThePromptGoesOn) {
  const std::string cell = cell_with("blind", "(single (device \"/dev/no-such-camera\"))");
  const Said said =
      run_cell("repl " + cell + " --agents vision --eval '(vision (connect))' --eval '(vision (learn 5 5 \"a\"))'" +
               " --eval '(ask (camera-state vision ?state ?trouble))'");
  EXPECT_TRUE(contains(said, "the camera: /dev/no-such-camera cannot be opened")) << said.text;
}

// The last word of the line that tells where the logs are.
std::string log_folder_of(const std::string& said) {
  const std::size_t at = said.find('/', said.find("logs"));
  return said.substr(at, said.find('\n', at) - at);
}

TEST(OwnEyes, ACameraThatIsNotThereIsNamedByLookByUpAndInTheLog) {
  const std::string cell = cell_with("no-eyes", "(single (device \"/dev/no-such-camera\"))");
  Running up({PIZARRA_CELL, "up", cell}, scratch_folder() + "no-eyes.log");
  const std::string patient = " --cell no-eyes --timeout 1";
  ASSERT_TRUE(
      wait_until([&] { return contains(run_cell("look" + patient), "vision-colour"); }, std::chrono::seconds(60)))
      << up.said();
  const Said resting = run_cell("look colour" + patient);
  EXPECT_EQ(resting.status, 1);
  EXPECT_TRUE(contains(resting, "(vision (connect))")) << resting.text;
  const std::string why = "the camera: /dev/no-such-camera cannot be opened";
  Said connected;
  const auto says_why = [&] {
    connected = run_cell("repl --cell no-eyes --eval '(vision (connect))' --eval '(vision (keep))'");
    return contains(connected, "\n  vision has no images: " + why + "\n");
  };
  // It says at first that the camera is being opened, if that takes long.
  EXPECT_TRUE(wait_until(says_why, std::chrono::seconds(60))) << connected.text;
  EXPECT_TRUE(contains(connected, "ok\n  until this prompt ends")) << connected.text;
  const Said looked = run_cell("look colour" + patient);
  EXPECT_EQ(looked.status, 1);
  EXPECT_TRUE(contains(looked, "no image came in 1 s: " + why)) << looked.text;
  const std::string told = "vision has no images: " + why + "\n";
  EXPECT_TRUE(wait_until([&] { return up.said().contains(told); }, std::chrono::seconds(10))) << up.said();
  const std::string log = log_folder_of(up.said()) + "/vision.log";
  EXPECT_TRUE(wait_until([&] { return whole_file(log).contains(told); }, std::chrono::seconds(10)))
      << log << whole_file(log);
  up.signal(SIGINT);
  EXPECT_EQ(up.end(std::chrono::seconds(20)), 0) << up.said();
}

TEST(OwnEyes, ACellOfEyesAloneNeedsNoDomainAndOneWithACoordinatorDoes) {
  const Said eyes = run_cell("check " + cell_with("alone", "(single (device 0))"));
  EXPECT_EQ(eyes.status, 0) << eyes.text;
  EXPECT_TRUE(contains(eyes, "no domain")) << eyes.text;
  const std::string file = scratch_folder() + "whole.scm";
  std::ofstream(file) << "(cell whole (camera (single (device 0))) (host \"localhost\" (agents vision coordinator)))";
  for (const std::string word : {"check ", "up "}) {
    const Said whole = run_cell(word + file);
    EXPECT_EQ(whole.status, 2) << whole.text;
    EXPECT_TRUE(contains(whole, "the cell names no file with (domain \"FILE\")")) << whole.text;
  }
}

TEST(OwnEyes, ACheckSaysWhichRecordingsAreNotHere) {
  const Said images = run_cell("check " + cell_with("no-images", "(single (images \"nowhere/*.png\"))"));
  EXPECT_EQ(images.status, 0) << images.text;
  EXPECT_TRUE(contains(images, "no-images.scm: warning: there are no images at ")) << images.text;
  const Said film = run_cell("check " + cell_with("no-film", "(single (video \"nowhere.avi\"))"));
  EXPECT_EQ(film.status, 0) << film.text;
  EXPECT_TRUE(contains(film, "warning: there is no film ")) << film.text;
  const std::string elsewhere = scratch_folder() + "elsewhere.scm";
  std::ofstream(elsewhere) << "(cell elsewhere (camera (single (video \"nowhere.avi\")))"
                           << " (host \"localhost\" (agents planner)) (host \"far\" (agents vision)))";
  EXPECT_FALSE(contains(run_cell("check " + elsewhere), "warning")) << "it may be there on the other host";
  const Said there = run_cell("check " + cell_with("there", "(single (images \"" + folder_of_photographs() + "\"))"));
  EXPECT_FALSE(contains(there, "warning")) << there.text;
}

TEST(OwnEyes, ACheckRefusesWhatWouldHaveNoEffectOnTheCamera) {
  const Said exposed = run_cell("check " + cell_with("exposed", "(single (images \"shots\")) (exposure 8)"));
  EXPECT_EQ(exposed.status, 2) << exposed.text;
  EXPECT_TRUE(contains(exposed, "only a (device ...) has (exposure MS)")) << exposed.text;
  const Said skewed = run_cell("check " + cell_with("skewed", "(single (device 0)) (skew 8)"));
  EXPECT_EQ(skewed.status, 2) << skewed.text;
}

TEST(OwnEyes, ThePromptSaysThatAModeEndsWithItAndKeepsIt) {
  const std::string cell = cell_with("kept", "(single (images \"" + folder_of_photographs() + "\")) (rate 60)");
  const Said kept = run_cell("repl " + cell + " --agents vision --eval '(vision (connect))' --eval '(vision (keep))'" +
                             " --eval '(ask (vision-held vision ?c ?m))'");
  EXPECT_TRUE(contains(kept, "until this prompt ends; (vision (keep)) lets it go on")) << kept.text;
  EXPECT_TRUE(contains(kept, "?c = anybody  ?m = connected")) << kept.text;
}

TEST(OwnEyes, ADemoHasTheSimulatedEyesInAnyCase) {
  const std::string file = scratch_folder() + "both.scm";
  std::ofstream(file)
      << "(cell both (world (cube circle (at 450 0))) (camera (single (device \"/dev/no-such-camera\")))"
      << " (domain \"" << source_dir() << "/domains/blocks.scm\"))";
  const Said said = run_cell("demo " + file + " --png '' --goal '(holding circle)'");
  EXPECT_EQ(said.status, 0) << said.text;
}

TEST(OwnEyes, ACellsCalibrationIsCheckedWithIt) {
  const std::string cell = cell_with("calibrated", "(single (device 0)) (calibration \"given.calibration\")");
  const auto check_with = [&](const std::string& text) {
    std::ofstream(scratch_folder() + "given.calibration") << text;
    return run_cell("check " + cell);
  };
  const std::string lens = "(focal 400 400) (centre 240 180) (distortion 0 0 0 0 0)";
  const std::string board = " (board 9 6 25)";
  const std::string one = "(calibration (size 480 360) (lens " + lens + ")" + board + " (errors 14 0.2))";
  EXPECT_EQ(check_with(one).status, 0);
  const Said garbage = check_with("never was a calibration\n");
  EXPECT_EQ(garbage.status, 2) << garbage.text;
  EXPECT_TRUE(contains(garbage, "given.calibration:1:")) << garbage.text;
  const Said pair =
      check_with("(calibration (size 480 360) (left " + lens + ") (right " + lens +
                 ") (rotation 1 0 0 0 1 0 0 0 1) (translation -80 0 0)" + board + " (errors 14 0.2 0.1))");
  EXPECT_EQ(pair.status, 2) << pair.text;
  EXPECT_TRUE(contains(pair, "is of a pair of cameras, and the cell has one")) << pair.text;
  std::filesystem::remove(scratch_folder() + "given.calibration");
  const Said none = run_cell("check " + cell);
  EXPECT_EQ(none.status, 2) << none.text;
  EXPECT_TRUE(contains(none, "given.calibration")) << none.text;
}

}  // namespace
}  // namespace pizarra::programs
