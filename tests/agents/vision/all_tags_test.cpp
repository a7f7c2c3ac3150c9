// Every tag in view, with nobody to point at it.

#include "agents/vision/marks/all_tags.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <set>

#include "agents/vision/marks/tag_text.hpp"
#include "agents/vision/sight/mark_pose.hpp"
#include "agents/vision/sight/tags_in_view.hpp"
#include "tests/bench/vision/scene.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

const TagFamily& family(std::string_view name) { return *family_from_text(name).value(); }

cv::Mat1b dark_cells(const Tag& tag) { return print_of(*family_called(tag.family), tag.number) == 0; }

void put(cv::Mat1b& image, const Tag& tag, cv::Point corner, int side_px) {
  cv::Mat1b dark;
  cv::resize(dark_cells(tag), dark, {side_px, side_px}, 0, 0, cv::INTER_NEAREST);
  image(cv::Rect(corner, dark.size())).setTo(30, dark);
}

std::vector<std::string> names_of(const std::vector<SeenMark>& seen) {
  std::vector<std::string> out;
  for (const SeenMark& mark : seen) out.push_back(tag_name(*mark.tag));
  return out;
}

TEST(AllTags, AreReadEachOnceHoweverManyAndWhateverElseIsThere) {
  cv::Mat1b image(960, 1280, std::uint8_t{170});
  std::set<std::string> shown;
  for (int i = 0; i < 70; ++i) {
    const Tag tag{i % 2 == 0 ? "apriltag-36h11" : "aruco-4x4-50", i / 2};
    const int cells = dark_cells(tag).cols;
    put(image, tag, {30 + 120 * (i % 10), 30 + 120 * (i / 10)}, cells * (7 + i % 3));
    shown.insert(tag_name(tag));
  }
  cv::rectangle(image, {60, 880, 60, 60}, 30, cv::FILLED);
  cv::GaussianBlur(image, image, {}, 0.8);
  const TagFamily* const both[] = {&family("36h11"), &family("4x4-50")};
  const std::vector<SeenMark> seen = all_tags(image, both);
  const std::vector<std::string> names = names_of(seen);
  EXPECT_EQ(names.size(), 70U);
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()), shown);
  EXPECT_TRUE(std::ranges::is_sorted(seen, std::greater<>(), &SeenMark::area_px)) << "the largest first";
  const std::vector<SeenMark> of_one = all_tags(image, std::span(both).first(1));
  EXPECT_EQ(of_one.size(), 35U) << "of the families that are named alone";
}

TEST(AllTags, ATagThatIsThereTwiceIsToldTwice) {
  cv::Mat1b image(240, 320, std::uint8_t{170});
  put(image, {"apriltag-36h11", 4}, {40, 80}, 56);
  put(image, {"apriltag-36h11", 4}, {200, 80}, 64);
  const TagFamily* const one[] = {&family("36h11")};
  const std::vector<SeenMark> seen = all_tags(image, one);
  ASSERT_EQ(seen.size(), 2U);
  EXPECT_LT(cv::norm(seen[0].centre - cv::Point2d(231.5, 111.5)), 0.5);
  EXPECT_LT(cv::norm(seen[1].centre - cv::Point2d(67.5, 107.5)), 0.5);
}

TEST(AllTags, WhatTwoFamiliesReadIsToldOnce) {
  cv::Mat1b image(240, 320, std::uint8_t{170});
  put(image, {"aruco-4x4-50", 7}, {100, 80}, 60);
  std::vector<const TagFamily*> every;
  for (const TagFamily& each : tag_families()) every.push_back(&each);
  EXPECT_EQ(names_of(all_tags(image, every)), std::vector<std::string>{"aruco-4x4-50-7"})
      << "the larger dictionary begins with the smaller";
}

struct Look {
  double side_px = 24;
  double motion_px = 0;  // any way
  double in_shadow = 1;  // how much of the light is left on one side of a line through the tag
  std::string family = "apriltag-36h11";
};

struct Shown {
  cv::Mat1b image;
  Tag tag;
  cv::Point2d middle;
};

cv::Mat1f moved_by(const cv::Mat1f& image, double px, Random& random) {
  const double way = random.uniform(0, 3.14);
  const int half = cvCeil(px / 2);
  cv::Mat1f along = cv::Mat1f::zeros(2 * half + 1, 2 * half + 1);
  const cv::Point2d step(std::cos(way) * px / 2, std::sin(way) * px / 2);
  const cv::Point middle(half, half);
  cv::line(along, middle - cv::Point(step), middle + cv::Point(step), 1);
  cv::Mat1f out;
  cv::filter2D(image, out, -1, along / cv::sum(along)[0], {-1, -1}, 0, cv::BORDER_REPLICATE);
  return out;
}

// Somewhere between pixels, turned, as a lens shows it.
Shown seen_somewhere(const Look& look, int number, Random& random) {
  constexpr int finer = 6;
  const Tag tag{look.family, number};
  const cv::Mat1b dark = dark_cells(tag);
  const double cell = look.side_px / dark.cols;
  const double turn = random.uniform(0, 6.28);
  const cv::Point2d middle(80 + random.uniform(-2, 2), 60 + random.uniform(-2, 2));
  const double shadow_turn = random.uniform(0, 6.28);
  const cv::Point2d into_shadow(std::cos(shadow_turn), std::sin(shadow_turn));
  const double edge = random.uniform(-0.4, 0.4) * look.side_px;
  cv::Mat1f fine(120 * finer, 160 * finer);
  for (int y = 0; y < fine.rows; ++y) {
    for (int x = 0; x < fine.cols; ++x) {
      const cv::Point2d at = cv::Point2d((x + 0.5) / finer - 0.5, (y + 0.5) / finer - 0.5) - middle;
      const cv::Point2d on(at.x * std::cos(turn) + at.y * std::sin(turn),
                           at.y * std::cos(turn) - at.x * std::sin(turn));
      const cv::Point cells(cvFloor(on.x / cell + dark.cols / 2.0), cvFloor(on.y / cell + dark.rows / 2.0));
      const bool is_dark = cv::Rect({0, 0}, dark.size()).contains(cells) && dark(cells) != 0;
      const double light = at.dot(into_shadow) > edge ? look.in_shadow : 1;
      fine(y, x) = static_cast<float>(light * (is_dark ? 30 : 190));
    }
  }
  cv::Mat1f image;
  cv::resize(fine, image, {160, 120}, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(image, image, {}, 0.7);
  if (look.motion_px > 0) image = moved_by(image, look.motion_px, random);
  for (float& level : image) level += static_cast<float>(random.uniform(-3, 3));
  Shown out{.image = {}, .tag = tag, .middle = middle};
  image.convertTo(out.image, CV_8U);
  return out;
}

// How many of the looks show a tag, none another one than is there; and how far off the middles are, px.
struct Read {
  int looks = 0;
  std::vector<double> off_px = {};

  double share() const { return static_cast<double>(off_px.size()) / looks; }
  double rms_px() const {
    return std::sqrt(std::inner_product(off_px.begin(), off_px.end(), off_px.begin(), 0.0) /
                     std::max<double>(1, static_cast<double>(off_px.size())));
  }
};

Read read_somewhere(const Look& look, std::uint64_t seed) {
  const TagFamily& family = *family_called(look.family);
  const TagFamily* const one[] = {&family};
  Random random(seed);
  Read out{.looks = campaign(60, 1000)};
  for (int i = 0; i < out.looks; ++i) {
    const Shown shown = seen_somewhere(look, 7 * i % tags_of(family), random);
    const std::vector<SeenMark> seen = all_tags(shown.image, one);
    EXPECT_LE(seen.size(), 1U);
    if (seen.empty()) continue;
    EXPECT_EQ(seen[0].tag, shown.tag) << "no other number is read";
    out.off_px.push_back(cv::norm(seen[0].centre - shown.middle));
  }
  return out;
}

// As tags of 40 mm look a metre away, their cells three or four pixels wide.
TEST(AllTags, AreReadFarAwayToATenthOfAPixel) {
  for (const char* family : {"apriltag-36h11", "aruco-4x4-50"}) {
    const Read read = read_somewhere({.side_px = 24, .family = family}, 4);
    EXPECT_GE(read.share(), 29.0 / 30) << family;
    EXPECT_LT(read.rms_px(), 0.1) << family;
  }
}

TEST(AllTags, AreReadWhereTheEdgeOfAShadowCrossesThem) {
  for (const char* family : {"apriltag-36h11", "aruco-4x4-50"}) {
    for (const double left : {0.3, 0.45, 0.6}) {
      const Read read = read_somewhere({.side_px = 50, .in_shadow = left, .family = family}, 5);
      EXPECT_GE(read.share(), 29.0 / 30) << family << ", " << left;
      EXPECT_LT(read.rms_px(), 0.4) << family << ", " << left;
    }
  }
}

TEST(AllTags, AreReadInMotionByACell) {
  for (const char* family : {"apriltag-36h11", "aruco-4x4-50"}) {
    const Read read = read_somewhere({.side_px = 52, .motion_px = 6.5, .family = family}, 6);
    EXPECT_GE(read.share(), 29.0 / 30) << family;
    EXPECT_LT(read.rms_px(), 0.3) << family;
  }
}

TEST(TagText, ATagIsAFamilyAndANumber) {
  EXPECT_EQ(tag_from_text("36h11:17").value(), (Tag{"apriltag-36h11", 17}));
  EXPECT_EQ(tag_from_text("aruco-4x4-50:0").value(), (Tag{"aruco-4x4-50", 0}));
  EXPECT_EQ(tag_from_text("original:1").value(), (Tag{"aruco-original", 1}));
  for (const char* none : {"", "36h11", "36h11:", "36h11:-1", "36h11:1x", "36h11:1-2", "36h11:+1"}) {
    EXPECT_EQ(tag_from_text(none).error().symbol, "bad-tag") << none;
  }
  EXPECT_EQ(tag_from_text("36h12:1").error().symbol, "unknown-family");
  EXPECT_EQ(tag_from_text(":").error().symbol, "unknown-family");
  EXPECT_EQ(tag_from_text("\xff:1").error().symbol, "unknown-family");
  EXPECT_EQ(tag_from_text("36h11:587").error().symbol, "no-such-tag") << "they end with 586";
  EXPECT_EQ(tag_from_text("36h11:99999999999").error().symbol, "no-such-tag");
}

TEST(TagText, ManyTagsAreSpansAndNumbers) {
  const auto numbers = [](std::string_view text) {
    std::vector<int> out;
    const std::vector<Tag> tags = tags_from_text(text).value();
    for (const Tag& tag : tags) out.push_back(tag.number);
    return out;
  };
  EXPECT_EQ(numbers("36h11:0-3,20"), (std::vector<int>{0, 1, 2, 3, 20}));
  EXPECT_EQ(numbers("36h11:5,4-6"), (std::vector<int>{5, 4, 6})) << "each once";
  for (const char* none : {"36h11:3-1", "36h11:1,,2", "36h11:1,", "36h11:1-2-3", "36h11:-3"}) {
    EXPECT_EQ(tags_from_text(none).error().symbol, "bad-tag") << none;
  }
}

// Frontal tags of 44 mm, half a metre away.
TEST(TagsInView, TellTheirPoseWithoutHavingBeenLearned) {
  constexpr double depth_mm = 500;
  Random random(5);
  bench::Scene scene;
  scene.marks = {{.name = "a", .centre = {110, 70}, .depth_mm = depth_mm, .tag = dark_cells({"apriltag-36h11", 17})},
                 {.name = "b", .centre = {210, 150}, .depth_mm = depth_mm, .tag = dark_cells({"aruco-4x4-50", 3})}};
  camera::StereoModel pair = bench::scene_camera();
  camera::StereoModel alone = pair;
  alone.base_line_mm = 0;
  const SizedFamily sized[] = {{"apriltag-36h11", 44}, {"aruco-4x4-50", 44}, {"no-family", 10}};
  const TagsInView look(sized);
  for (const camera::StereoModel& model : {pair, alone}) {
    const StereoSight sight(bench::draw(scene, bench::Side::left, random),
                            bench::draw(scene, bench::Side::right, random), model);
    const std::vector<FoundMark> seen = look.at(sight);
    ASSERT_EQ(seen.size(), 2U);
    for (const FoundMark& tag : seen) {
      const bench::SceneMark& truth = scene.marks[tag.name == "aruco-4x4-50-3" ? 1 : 0];
      EXPECT_EQ(tag.pair.right.has_value(), !model.is_single()) << tag.name;
      EXPECT_GT(tag.confidence, 0.9) << tag.name;
      ASSERT_TRUE(tag.pose) << tag.name;
      const double z_spread = spreads_of(*tag.pose)[2];
      EXPECT_LT(std::abs(tag.pose->place_mm[2] - depth_mm), 4 * z_spread) << tag.name;
      EXPECT_LT(z_spread, model.is_single() ? 10 : 2) << tag.name;
      const double x = (truth.centre.x - model.centre_x_px) * depth_mm / model.focal_px - model.base_line_mm / 2;
      EXPECT_NEAR(tag.pose->place_mm[0], x, 2) << tag.name;
    }
  }
}

TEST(TagsInView, WithoutASizeHaveAPlaceInTheImageAndNoPose) {
  Random random(6);
  bench::Scene scene;
  scene.marks = {{.name = "a", .centre = {110, 70}, .depth_mm = 500, .tag = dark_cells({"apriltag-36h11", 17})}};
  camera::StereoModel alone = bench::scene_camera();
  alone.base_line_mm = 0;
  const cv::Mat1b left = bench::draw(scene, bench::Side::left, random);
  const SizedFamily unsized[] = {{"apriltag-36h11", 0}};
  const std::vector<FoundMark> seen = TagsInView(unsized).at(StereoSight(left, left, alone));
  ASSERT_EQ(seen.size(), 1U);
  EXPECT_FALSE(seen[0].pose);
  EXPECT_LT(cv::norm(seen[0].pair.left.centre - cv::Point2d(110, 70)), 0.5);
}

}  // namespace
}  // namespace pizarra::vision
