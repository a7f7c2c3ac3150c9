// Tags with cells around their square: AprilTag's Standard41h12, Circle21h7 and Standard52h13.

#include <algorithm>
#include <apriltag/apriltag.h>
#include <apriltag/tagCircle21h7.h>
#include <apriltag/tagStandard41h12.h>
#include <apriltag/tagStandard52h13.h>
#include <filesystem>
#include <gtest/gtest.h>
#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/marks/all_tags.hpp"
#include "agents/vision/marks/tag_wide.hpp"
#include "agents/vision/marks/tags.hpp"
#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_pose.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "agents/vision/sight/tags_in_view.hpp"
#include "tests/bench/vision/scene.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

using bench::Side;

const std::vector<std::string> names = {"apriltag-standard41h12", "apriltag-circle21h7", "apriltag-standard52h13"};

const TagFamily& family(const std::string& name) { return *family_called(name); }

std::vector<const TagFamily*> wide_families() {
  std::vector<const TagFamily*> out;
  for (const std::string& name : names) out.push_back(&family(name));
  return out;
}

std::vector<const TagFamily*> every_family() {
  std::vector<const TagFamily*> out;
  for (const TagFamily& each : tag_families()) out.push_back(&each);
  return out;
}

Tag random_tag(const std::string& name, Random& random) {
  return {name, static_cast<int>(random.below(static_cast<std::uint64_t>(tags_of(family(name)))))};
}

// A tag as libapriltag draws it, of the cells that are printed.
using Codes = std::unique_ptr<apriltag_family_t, void (*)(apriltag_family_t*)>;

void expect_drawn_alike(const std::string& name, const Codes& codes, int number) {
  image_u8_t* const drawn = apriltag_to_image(codes.get(), static_cast<std::uint32_t>(number));
  const cv::Mat1b theirs =
      cv::Mat(drawn->height, drawn->width, CV_8U, drawn->buf, static_cast<std::size_t>(drawn->stride));
  const cv::Mat1b ours = print_of(family(name), number);
  ASSERT_EQ(ours.size(), theirs.size());
  EXPECT_EQ(cv::countNonZero((ours != theirs) & (ours != unprinted)), 0) << name << " " << number;
  EXPECT_EQ(cv::countNonZero(ours == unprinted) > 0, name == "apriltag-circle21h7");
  image_u8_destroy(drawn);
}

TEST(WideTags, AreDrawnAsLibapriltagDrawsThem) {
  const Codes standard41(tagStandard41h12_create(), tagStandard41h12_destroy);
  const Codes circle21(tagCircle21h7_create(), tagCircle21h7_destroy);
  const Codes standard52(tagStandard52h13_create(), tagStandard52h13_destroy);
  for (const int number : {0, 1, 17, 2114}) expect_drawn_alike(names[0], standard41, number);
  for (const int number : {0, 1, 17, 37}) expect_drawn_alike(names[1], circle21, number);
  for (const int number : {0, 1, 17, 48713}) expect_drawn_alike(names[2], standard52, number);
  EXPECT_EQ(tags_of(family(names[0])), 2115);
  EXPECT_EQ(tags_of(family(names[1])), 38);
  EXPECT_EQ(tags_of(family(names[2])), 48714);
}

// A tag on grey ground, as a camera 320 by 240 px large sees it.
struct TiltedTag {
  cv::Mat1b image;
  TagCorners corners;
};

// Tilted and turned, its square about that wide, somewhere between pixels. Each pixel is the mean of many places in it.
TiltedTag tilted(const Tag& tag, double side_px, double most_tilt_deg, Random& random) {
  constexpr double focal_px = 400;
  constexpr int finer = 4;
  const cv::Mat1b print = print_of(family(tag.family), tag.number);
  const double half_cells = print.cols / 2.0;
  const double side_cells = print.cols - 2 * family(tag.family).cells_around;
  const double turn = random.uniform(0, 2 * CV_PI);
  const double tilt = random.uniform(0, most_tilt_deg) * CV_PI / 180;
  const double toward = random.uniform(0, 2 * CV_PI);
  cv::Matx33d rotation;
  cv::Rodrigues(cv::Vec3d(tilt * std::cos(toward), tilt * std::sin(toward), 0), rotation);
  rotation = rotation * cv::Matx33d(std::cos(turn), -std::sin(turn), 0, std::sin(turn), std::cos(turn), 0, 0, 0, 1);
  const double away = side_cells * focal_px / side_px;
  const cv::Vec3d place(random.uniform(-3, 3) * away / focal_px, random.uniform(-3, 3) * away / focal_px, away);
  const cv::Matx33d camera(focal_px, 0, 160, 0, focal_px, 120, 0, 0, 1);
  // From cells, counted from the middle, to pixels.
  const cv::Matx33d to_image = camera * cv::Matx33d(rotation(0, 0), rotation(0, 1), place[0], rotation(1, 0),
                                                    rotation(1, 1), place[1], rotation(2, 0), rotation(2, 1), place[2]);
  const cv::Matx33d to_cells = to_image.inv();
  TiltedTag out;
  cv::Mat1f fine(240 * finer, 320 * finer);
  for (int y = 0; y < fine.rows; ++y) {
    for (int x = 0; x < fine.cols; ++x) {
      const cv::Vec3d on = to_cells * cv::Vec3d((x + 0.5) / finer - 0.5, (y + 0.5) / finer - 0.5, 1);
      const cv::Point cell(cvFloor(on[0] / on[2] + half_cells), cvFloor(on[1] / on[2] + half_cells));
      const bool printed = cv::Rect({0, 0}, print.size()).contains(cell) && print(cell) != unprinted;
      fine(y, x) = printed ? 30.F + static_cast<float>(print(cell)) * 170 / 255 : 150.F;
    }
  }
  cv::Mat1f seen;
  cv::resize(fine, seen, {320, 240}, 0, 0, cv::INTER_AREA);
  cv::GaussianBlur(seen, seen, {}, 0.7);
  for (float& level : seen) level += static_cast<float>(3 * random.normal());
  seen.convertTo(out.image, CV_8U);
  const double s = side_cells / 2;
  for (const cv::Vec3d& corner : {cv::Vec3d(-s, -s, 1), cv::Vec3d(s, -s, 1), cv::Vec3d(s, s, 1), cv::Vec3d(-s, s, 1)}) {
    const cv::Vec3d at = to_image * corner;
    out.corners.emplace_back(static_cast<float>(at[0] / at[2]), static_cast<float>(at[1] / at[2]));
  }
  return out;
}

TEST(WideTags, AreReadInPerspectiveAndTheirCornersAreRightToAFractionOfAPixel) {
  const int looks = campaign(20, 60);
  for (const std::string& name : names) {
    Random random(11);
    const TagFamily* const one[] = {&family(name)};
    int read = 0;
    double squares = 0;
    for (int i = 0; i < looks; ++i) {
      const Tag tag = random_tag(name, random);
      const TiltedTag shown = tilted(tag, random.uniform(24, 80), 45, random);
      const std::vector<SeenMark> seen = all_tags(shown.image, one);
      ASSERT_LE(seen.size(), 1U) << tag_name(tag);
      if (seen.empty()) continue;
      ++read;
      ASSERT_EQ(seen[0].tag, tag);
      for (std::size_t k = 0; k < 4; ++k) {
        const double off = cv::norm(seen[0].corners[k] - shown.corners[k]);
        EXPECT_LT(off, 1) << tag_name(tag) << ", corner " << k;
        squares += off * off / 4;
      }
    }
    EXPECT_GE(read, looks * 59 / 60) << name;
    EXPECT_LT(std::sqrt(squares / read), 0.25) << name;
  }
}

TEST(WideTags, AreReadAsNothingElse) {
  Random random(12);
  for (int i = 0; i < 24; ++i) {
    const Tag tag = random_tag(names[static_cast<std::size_t>(i) % names.size()], random);
    const TiltedTag shown = tilted(tag, random.uniform(30, 80), 40, random);
    const std::vector<SeenMark> seen = all_tags(shown.image, every_family());
    ASSERT_EQ(seen.size(), 1U) << tag_name(tag);
    EXPECT_EQ(seen[0].tag, tag);
  }
}

// The clicks go through the tag, from cell to cell, those around its square too.
TEST(WideTags, AreReadWhereverOneClicksInThem) {
  Random random(13);
  for (const std::string& name : names) {
    const Tag tag = random_tag(name, random);
    const TiltedTag shown = tilted(tag, 60, 30, random);
    const cv::Point2d middle = (shown.corners[0] + shown.corners[2]) / 2;
    const cv::Point2d half = cv::Point2d(shown.corners[1] + shown.corners[2]) / 2 - middle;
    for (const double at : {-1.5, -0.8, -0.3, 0.0, 0.5, 0.9, 1.2}) {
      const std::optional<SeenMark> seen = tag_at(shown.image, middle + at * half).value();
      ASSERT_TRUE(seen) << tag_name(tag) << " clicked at " << at;
      EXPECT_EQ(seen->tag, tag);
    }
    EXPECT_FALSE(tag_at(shown.image, {5, 5}).value()) << "the ground";
  }
}

TEST(WideTags, OneThatIsPartlyHiddenIsNotToldElsewhere) {
  Random random(14);
  for (int i = 0; i < campaign(50, 150); ++i) {
    const Tag tag = random_tag(names[static_cast<std::size_t>(i) % names.size()], random);
    TiltedTag shown = tilted(tag, 60, 0, random);
    const cv::Point2f middle = (shown.corners[0] + shown.corners[2]) / 2;
    const cv::Point2f along = shown.corners[1] - shown.corners[0];
    const cv::Point2f across = shown.corners[3] - shown.corners[0];
    const auto covered = static_cast<float>(random.uniform(0.02, 0.5));
    std::vector<cv::Point> hand;
    for (const cv::Point2f& at : {cv::Point2f(-1.5F, -1.5F), cv::Point2f(1.5F, -1.5F),
                                  cv::Point2f(1.5F, covered - 0.5F), cv::Point2f(-1.5F, covered - 0.5F)}) {
      hand.emplace_back(middle + at.x * along + at.y * across);
    }
    cv::fillConvexPoly(shown.image, hand, static_cast<double>(random.uniform(20, 220)));
    for (const SeenMark& seen : all_tags(shown.image, wide_families())) {
      EXPECT_EQ(seen.tag, tag);
      EXPECT_LT(cv::norm(seen.centre - cv::Point2d(middle)), 1.2) << covered;
    }
  }
}

// Two of them before a pair, half a metre away; 44 mm with the cells around their squares.
class WideTagsOfAPair : public testing::TestWithParam<std::string> {
 protected:
  WideTagsOfAPair() {
    scene.marks = {{.name = "a", .centre = {110, 90}, .depth_mm = depth_mm, .tag = dark_cells(3)},
                   {.name = "b", .centre = {215, 120}, .depth_mm = depth_mm, .tag = dark_cells(11)}};
  }
  cv::Mat1b dark_cells(int number) const { return print_of(family(GetParam()), number) == 0; }
  double side_mm() const {
    const int cells = print_of(family(GetParam()), 0).cols;
    return 44.0 * (cells - 2 * family(GetParam()).cells_around) / cells;
  }
  StereoSight look() {
    return {bench::draw(scene, Side::left, random), bench::draw(scene, Side::right, random), model};
  }
  void learn(const bench::SceneMark& mark) {
    MarkLearner learner(mark.name, mark.centre + cv::Point2d(3, 2), objects);
    while (!learner.done()) {
      StereoSight sight = look();
      const Result<void> fed = learner.feed(sight);
      ASSERT_TRUE(fed) << fed.error().sentence;
    }
    LearnedSample sample = learner.sample();
    sample.number = 1;
    objects.add(mark.name, std::move(sample));
  }

  static constexpr double depth_mm = 450;
  bench::Scene scene;
  Random random{9};
  camera::StereoModel model = bench::scene_camera();
  LearnedObjects objects;
};

TEST_P(WideTagsOfAPair, AreLearnedByAClickFoundAndTracked) {
  for (const bench::SceneMark& mark : scene.marks) learn(mark);
  ASSERT_EQ(*objects.find("a")->tag(), (Tag{GetParam(), 3}));
  scene.marks[0].centre += cv::Point2d(20, 10);
  scene.marks[0].turn_deg = 35;
  StereoSight first = look();
  EXPECT_TRUE(first.find(objects, *objects.find("a")));
  MarkTracker tracker(objects);
  for (const bench::SceneMark& mark : scene.marks) ASSERT_TRUE(tracker.add(*objects.find(mark.name)));
  Time now = {};
  for (int frame = 0; frame < 4; ++frame) {
    StereoSight sight = look();
    const std::vector<TrackSighting> seen = tracker.update(sight, now += 100ms);
    for (std::size_t i = 0; i < scene.marks.size(); ++i) {
      ASSERT_TRUE(seen[i].seen) << seen[i].name << " in frame " << frame;
      EXPECT_LT(cv::norm(seen[i].centre - scene.marks[i].centre), 0.5) << seen[i].name;
      const double expected = range_at_depth_mm(model, scene.marks[i].centre, depth_mm);
      EXPECT_NEAR(seen[i].range_mm, expected, 0.01 * expected) << seen[i].name;
      scene.marks[i].centre += cv::Point2d(3, -2);
    }
  }
}

TEST_P(WideTagsOfAPair, TellTheirPoseByTheSideOfTheirSquare) {
  camera::StereoModel alone = model;
  alone.base_line_mm = 0;
  const SizedFamily sized[] = {{GetParam(), side_mm()}};
  for (const camera::StereoModel& each : {model, alone}) {
    const StereoSight sight(bench::draw(scene, Side::left, random), bench::draw(scene, Side::right, random), each);
    const std::vector<FoundMark> seen = TagsInView(sized).at(sight);
    ASSERT_EQ(seen.size(), 2U);
    for (const FoundMark& tag : seen) {
      ASSERT_TRUE(tag.pose) << tag.name;
      const double z_spread = spreads_of(*tag.pose)[2];
      EXPECT_LT(std::abs(tag.pose->place_mm[2] - depth_mm), 4 * z_spread) << tag.name;
      EXPECT_LT(z_spread, each.is_single() ? 12 : 2) << tag.name;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Families, WideTagsOfAPair, testing::ValuesIn(names),
                         [](const auto& one) { return one.param.substr(one.param.find('-') + 1); });

TEST(WideTags, AreNotReadInSceneryOfShapesAndOtherTags) {
  Random random(15);
  for (int i = 0; i < campaign(20, 60); ++i) {
    bench::Scene scene = bench::random_scene(bench::hard_ranges, random);
    std::vector<cv::Mat1b> others;
    for (int k = 0; k < 5; ++k) {
      const TagFamily& other = tag_families()[random.below(tag_families().size() - names.size())];
      others.emplace_back(print_of(other, static_cast<int>(random.below(30))) == 0);
    }
    if (i % 2 == 0) scene = bench::with_tags(scene, others);
    const std::vector<SeenMark> seen = all_tags(bench::draw(scene, Side::left, random), wide_families());
    ASSERT_TRUE(seen.empty()) << tag_name(*seen[0].tag) << " in scene " << i;
  }
}

// Debian's package opencv-doc has photographs of rooms, streets, fruit and people.
TEST(WideTags, AreNotReadInPhotographsWithoutThem) {
  const std::filesystem::path folder = "/usr/share/doc/opencv-doc/examples/data";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "opencv-doc is not installed";
  int looked_at = 0;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    const cv::Mat1b image = cv::imread(file.path(), cv::IMREAD_GRAYSCALE);
    if (image.empty()) continue;
    ++looked_at;
    for (const SeenMark& seen : all_tags(image, wide_families())) {
      ADD_FAILURE() << tag_name(*seen.tag) << " in " << file.path();
    }
  }
  EXPECT_GT(looked_at, 20);
}

TEST(WideTags, AreNotSoughtInWhatIsSmallerThanAnyOfThem) {
  for (const cv::Size& size : {cv::Size(1, 1), cv::Size(3, 200), cv::Size(200, 15), cv::Size(16, 16)}) {
    EXPECT_TRUE(all_tags(cv::Mat1b(size, std::uint8_t{90}), wide_families()).empty()) << size;
  }
}

}  // namespace
}  // namespace pizarra::vision
