// Image files without a cell: `find`, `measure`, and the sheets of tags that they read.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <opencv2/aruco.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <regex>
#include <sstream>

#include "tests/agents/vision/photograph.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

Said run(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }

int count(const std::string& text, const std::string& part) {
  int out = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++out;
  return out;
}

// The numbers behind a word of the text.
std::vector<double> numbers_behind(const std::string& text, const std::string& word) {
  const std::size_t at = text.find(word);
  if (at == std::string::npos) return {};
  std::istringstream in(text.substr(at + word.size()));
  std::vector<double> out;
  for (double number = 0; in >> number;) out.push_back(number);
  return out;
}

vision::Photograph photograph_of(int i) { return {.tilt_deg = 10, .pan_deg = 5.0 * i}; }

// Three photographs of the printed sheet, 0.jpg the one to learn from, in a folder that begins empty.
std::string folder_of_photographs(const std::string& name) {
  std::string folder = scratch_folder() + name + "/";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  Random random(3);
  for (int i = 0; i < 3; ++i) cv::imwrite(fmt::format("{}{}.jpg", folder, i), photograph_of(i).take(random));
  return folder;
}

std::string learn_from(const std::string& folder, const std::string& shape) {
  const cv::Point2d at = photograph_of(0).seen_at(shape);
  return fmt::format(" --learn {}0.jpg {:.0f} {:.0f}", folder, at.x, at.y);
}

// A frontal tag 96 px wide whose middle is at (149.5, 109.5) of 320 x 240.
void write_tag(const std::string& file, int number) {
  cv::Mat print;
  cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11)->drawMarker(number, 96, print);
  cv::Mat1b image(240, 320, std::uint8_t{180});
  print = 30 + print / 1.5;
  print.copyTo(image(cv::Rect(102, 62, 96, 96)));
  ASSERT_TRUE(cv::imwrite(scratch_folder() + file, image));
}

TEST(Find, TellsOfEveryImageWhereWhatItLearnedFromOneIs) {
  const std::string folder = folder_of_photographs("find-all");
  for (const char* shape : {"circle", "cross"}) {
    const Said said = run(fmt::format("find {} {}{}", shape, folder, learn_from(folder, shape)));
    EXPECT_EQ(said.status, 0) << said.text;
    for (int i = 0; i < 3; ++i) {
      const std::string line = fmt::format("{}{}.jpg: (FIND \"{}\" OK (", folder, i, shape);
      double x = 0;
      double y = 0;
      ASSERT_NE(said.text.find(line), std::string::npos) << said.text;
      const std::string rest = said.text.substr(said.text.find(line) + line.size());
      ASSERT_EQ(std::sscanf(rest.c_str(), "%lf, %lf)) confidence", &x, &y), 2) << said.text;
      EXPECT_LT(cv::norm(cv::Point2d(x, y) - photograph_of(i).seen_at(shape)), 1) << said.text;
    }
    EXPECT_EQ(count(said.text, " place "), 0) << "nobody said what a pixel is";
  }
}

TEST(Find, TellsThePoseWhereTheFocalLengthIsKnown) {
  const std::string folder = folder_of_photographs("find-pose");
  const vision::Photograph learned = photograph_of(0);
  const Said said = run(fmt::format("find square {}2.jpg{} --learned-at {:.0f} --focal {:.0f}", folder,
                                    learn_from(folder, "square"), learned.range_mm({-45, 35}), learned.focal_px()));
  EXPECT_EQ(said.status, 0) << said.text;
  const std::vector<double> place = numbers_behind(said.text, "place ");
  ASSERT_EQ(place.size(), 3U) << said.text;
  const double range = std::hypot(place[0], place[1], place[2]);
  EXPECT_NEAR(range, photograph_of(2).range_mm({-45, 35}), 15) << said.text;
  EXPECT_EQ(numbers_behind(said.text, "mm, off by ").size(), 3U) << said.text;
  EXPECT_EQ(numbers_behind(said.text, "turned ").size(), 3U) << said.text;
}

TEST(Find, ATagNeedsNoLearningAndItsSideTellsHowFarAwayItIs) {
  write_tag("tag-17.png", 17);
  const Said said = run("find 36h11:17 tag-17.png --focal 500 --side 50");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "tag-17.png: (FIND \"apriltag-36h11-17\" OK (149.")) << said.text;
  const std::vector<double> place = numbers_behind(said.text, "place ");
  ASSERT_EQ(place.size(), 3U) << said.text;
  EXPECT_NEAR(place[0], -10 * 50 / 96.0, 0.5);
  EXPECT_NEAR(place[1], -10 * 50 / 96.0, 0.5);
  EXPECT_NEAR(place[2], 500 * 50 / 96.0, 3);
  const Said json = run("find apriltag-36h11:17 tag-17.png --json");
  EXPECT_EQ(json.text.find("{\"image\":\"tag-17.png\",\"reply\":\"(FIND \\\"apriltag-36h11-17\\\" OK ("), 0U)
      << json.text;
}

TEST(Find, AnImageWithoutItOrThatCannotBeReadIsToldAndTheOthersAreLookedAt) {
  write_tag("tag-17.png", 17);
  write_tag("tag-18.png", 18);
  const Said missing = run("find 36h11:17 tag-18.png tag-17.png");
  EXPECT_EQ(missing.status, 1) << missing.text;
  EXPECT_TRUE(contains(missing, "tag-18.png: (FIND \"apriltag-36h11-17\" FAIL) not-seen: ")) << missing.text;
  EXPECT_TRUE(contains(missing, "tag-17.png: (FIND \"apriltag-36h11-17\" OK (")) << missing.text;
  std::ofstream(scratch_folder() + "no-image.png") << "nothing";
  const Said damaged = run("find 36h11:17 no-image.png tag-18.png tag-17.png");
  EXPECT_EQ(damaged.status, 4) << damaged.text;
  EXPECT_TRUE(contains(damaged, "no-image.png is no image that can be read")) << damaged.text;
  EXPECT_TRUE(contains(damaged, "tag-17.png: (FIND \"apriltag-36h11-17\" OK (")) << damaged.text;
}

TEST(Find, KnowsWhatACellsEyesHaveLearned) {
  const std::string folder = folder_of_photographs("find-cell");
  const std::string objects = scratch_folder() + "find-objects";
  std::filesystem::remove_all(objects);
  std::ofstream(scratch_folder() + "find-cell.scm")
      << "(cell find-cell (objects \"" << objects << "\") (camera (single (images \"" << folder
      << "0.jpg\")) (rate 60)) (host \"localhost\" (agents vision)))";
  const cv::Point2d at = photograph_of(0).seen_at("cross");
  const Said learned = run(
      fmt::format("repl find-cell.scm --agents vision --eval '(vision (learn {:.0f} {:.0f} \"cross\"))'", at.x, at.y));
  ASSERT_TRUE(contains(learned, "(LEARN \"cross\" OK)")) << learned.text;
  const Said found = run("find cross " + folder + "1.jpg --learned " + objects);
  EXPECT_EQ(found.status, 0) << found.text;
  EXPECT_TRUE(contains(found, "(FIND \"cross\" OK (")) << found.text;
  const Said unknown = run("find star " + folder + "1.jpg --learned " + objects);
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown, "under the name star")) << unknown.text;
  EXPECT_TRUE(contains(unknown, "\"cross\"")) << unknown.text;
}

TEST(Find, WhatMakesNoSenseIsRefusedWithOneSentence) {
  write_tag("tag-17.png", 17);
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"find circle tag-17.png", "--learned FOLDER"},
      {"find 36h11:17 tag-17.png --learn tag-17.png 5 5", "without --learned and --learn"},
      {"find 36h11:700 tag-17.png", "has the tags 0 to 586"},
      {"find 36h12:7 tag-17.png", "there is no family of tags 36h12"},
      {"find 36h11:17 tag-17.png --side 50", "nothing without --focal"},
      {"find circle tag-17.png --learn tag-17.png 5 x", "x is no number"},
      {"find circle tag-17.png --learn tag-17.png 5 5", "ground"},
      {"find 'cir cle' tag-17.png --learn tag-17.png 160 120", "cir cle"},
      {"find \"$(printf 'c\\377')\" tag-17.png --learn tag-17.png 160 120", "a name is a letter"},
  };
  for (const auto& [words, sentence] : wrong) {
    const Said said = run(words);
    EXPECT_EQ(said.status, 2) << words << "\n" << said.text;
    EXPECT_TRUE(contains(said, sentence)) << words << "\n" << said.text;
  }
}

TEST(Measure, TellsOfEveryMarkItsPlaceSizeTurnAreaAndPerimeter) {
  cv::Mat1b image(240, 320, std::uint8_t{180});
  cv::rectangle(image, {40, 60, 80, 40}, 30, cv::FILLED);
  const cv::RotatedRect turned({220, 120}, {70, 30}, 30);
  cv::Point2f corners[4];
  turned.points(corners);
  std::vector<cv::Point> inside(corners, corners + 4);
  cv::fillConvexPoly(image, inside, 30);
  ASSERT_TRUE(cv::imwrite(scratch_folder() + "rectangles.png", image));
  const Said said = run("measure rectangles.png");
  EXPECT_EQ(said.status, 0);
  EXPECT_TRUE(contains(said, "rectangles.png: 320 x 240 px, 2 marks, 0 tags\n")) << said.text;
  EXPECT_TRUE(contains(said,
                       "dark mark at 79.50 79.50 px, size 80.0 x 40.0 px, turned 0.0 degrees, area 3200 px, "
                       "perimeter 236 px\n"))
      << said.text;
  std::smatch other;
  ASSERT_TRUE(std::regex_search(said.text, other, std::regex("turned ([1-9][0-9.]*) degrees"))) << said.text;
  EXPECT_NEAR(std::stod(other[1]), 30, 2) << said.text;
}

TEST(Measure, TellsOfTagsAndTheirPose) {
  write_tag("tag-17.png", 17);
  const Said said = run("measure tag-17.png --focal 500 --side 50");
  EXPECT_EQ(said.status, 0);
  EXPECT_TRUE(contains(said, "tag-17.png: 320 x 240 px, 0 marks, 1 tag\n  tag apriltag-36h11-17 at 149.")) << said.text;
  const std::vector<double> place = numbers_behind(said.text, "place ");
  ASSERT_EQ(place.size(), 3U) << said.text;
  EXPECT_NEAR(place[2], 500 * 50 / 96.0, 3);
  EXPECT_TRUE(contains(run("measure tag-17.png --tags 4x4-50,25h9"), "0 tags")) << "of other families";
  const Said unknown = run("measure tag-17.png --tags 4x4-50,25h8");
  EXPECT_EQ(unknown.status, 2);
  EXPECT_TRUE(contains(unknown, "there is no family of tags 25h8")) << unknown.text;
  EXPECT_EQ(run("measure no-such-file.png").status, 4);
}

// Printed, scanned at its own 300 dots an inch, and read.
TEST(TagSheet, IsReadBackAtItsRealSize) {
  ASSERT_EQ(run("shapes --print tags.png --tags 36h11:0-11").status, 0);
  const Said said = run("measure tags.png --tags 36h11 --json");
  ASSERT_EQ(said.status, 0) << said.text;
  const std::regex tag("\\{\"tag\":\"apriltag-36h11-([0-9]+)\",\"at\":\\[([0-9.]+),([0-9.]+)\\],\"side\":([0-9.]+),");
  std::vector<int> numbers;
  std::vector<cv::Point2d> places;
  constexpr double dots_a_mm = 300 / 25.4;
  for (std::sregex_iterator at(said.text.begin(), said.text.end(), tag), end; at != end; ++at) {
    numbers.push_back(std::stoi((*at)[1]));
    places.emplace_back(std::stod((*at)[2]), std::stod((*at)[3]));
    EXPECT_NEAR(std::stod((*at)[4]) / dots_a_mm, 40, 0.2) << "mm";
  }
  std::vector<int> sorted = numbers;
  std::ranges::sort(sorted);
  EXPECT_EQ(sorted, (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11})) << said.text;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) EXPECT_GT(cv::norm(places[i] - places[j]) / dots_a_mm, 55) << "they lie apart";
  }
}

TEST(TagSheet, OfTagsWithCellsAroundTheirSquareIsReadBackByTheSideOfTheSquare) {
  const std::vector<std::pair<std::string, std::string>> families = {
      {"standard41h12", "0-10,2114"}, {"circle21h7", "0-10,37"}, {"standard52h13", "0-10,48713"}};
  for (const auto& [family, numbers] : families) {
    ASSERT_EQ(run("shapes --print tags.png --tags " + family + ":" + numbers).status, 0);
    const Said said = run("measure tags.png --tags " + family + " --json");
    ASSERT_EQ(said.status, 0) << said.text;
    const std::regex tag("\\{\"tag\":\"apriltag-" + family +
                         "-([0-9]+)\",\"at\":\\[[0-9.]+,[0-9.]+\\],\"side\":([0-9.]+),");
    std::vector<int> read;
    for (std::sregex_iterator at(said.text.begin(), said.text.end(), tag), end; at != end; ++at) {
      read.push_back(std::stoi((*at)[1]));
      EXPECT_NEAR(std::stod((*at)[2]) / (300 / 25.4), 25, 0.2) << "mm";
    }
    std::ranges::sort(read);
    ASSERT_EQ(read.size(), 12U) << said.text;
    EXPECT_EQ(read[10], 10) << said.text;
    EXPECT_EQ(std::to_string(read[11]), numbers.substr(5));
  }
}

// From its left border to its right one, and from its upper one to its lower, in the dark that is there.
TEST(TagSheet, IsAsLargeAsItSays) {
  ASSERT_EQ(run("shapes --print one-tag.png --tags 36h11:0 --side 40").status, 0);
  const cv::Mat1b page = cv::imread(scratch_folder() + "one-tag.png", cv::IMREAD_GRAYSCALE);
  constexpr double dots_a_mm = 300 / 25.4;
  // Along the outermost cells, which are dark all around.
  constexpr double cell_mm = 5;
  const cv::Point2d corner(25, 30);
  const auto dots = [&](double mm) { return cvRound(mm * dots_a_mm); };
  const auto dark_mm = [&](const cv::Rect& line) { return cv::sum(255 - page(line))[0] / 255 / dots_a_mm; };
  const int across = dots(corner.y + cell_mm / 2);
  const int down = dots(corner.x + cell_mm / 2);
  const int length = dots(52);
  EXPECT_NEAR(dark_mm({dots(corner.x - 6), across, length, 1}), 40, 0.01);
  EXPECT_NEAR(dark_mm({down, dots(corner.y - 6), 1, length}), 40, 0.01);
}

TEST(TagSheet, WhatDoesNotFitOrIsNoTagIsRefused) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"--tags 36h11:0-99", "a page of A4 has room for 12 tags of 40 mm, and 100 are wanted"},
      {"--tags 36h11:0 --side 190", "has room for 0"},
      {"--tags 36h11:0 --side 2", "mm is the least"},
      {"--tags 36h11:5-3", "is no tag"},
      {"--tags 36h99:1", "there is no family of tags 36h99"},
      {"--tags 36h11:0 --board", "--board"},
      {"--side 30", "--tags"},
  };
  for (const auto& [words, sentence] : wrong) {
    const Said said = run("shapes --print refused.png " + words);
    EXPECT_EQ(said.status, 2) << words << "\n" << said.text;
    EXPECT_TRUE(contains(said, sentence)) << words << "\n" << said.text;
    EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "refused.png")) << words;
  }
}

}  // namespace
}  // namespace pizarra::programs
