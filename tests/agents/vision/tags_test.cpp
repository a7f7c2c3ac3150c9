#include "agents/vision/marks/tags.hpp"

#include <gtest/gtest.h>
#include <numeric>
#include <opencv2/aruco.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/vision/objects/sample_facts.hpp"
#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/scene.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

using bench::Side;

cv::Mat1b cells_of(cv::aruco::PREDEFINED_DICTIONARY_NAME family, int number) {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family);
  cv::Mat drawn;
  dictionary->drawMarker(number, dictionary->markerSize + 2, drawn);
  return drawn == 0;
}

// The tag that is read there, or why none is.
std::string read_at(const cv::Mat1b& image, cv::Point2d click) {
  const Result<std::optional<SeenMark>> seen = tag_at(image, click);
  if (!seen) return seen.error().symbol;
  return *seen ? tag_name(*(*seen)->tag) : "none";
}

// Two tags and a plain square on light ground, half a metre away.
class Tags : public testing::Test {
 protected:
  Tags() {
    scene.marks = {
        {.name = "a", .centre = {110, 70}, .depth_mm = depth_mm, .tag = cells_of(cv::aruco::DICT_APRILTAG_36h11, 17)},
        {.name = "b", .centre = {210, 80}, .depth_mm = depth_mm, .tag = cells_of(cv::aruco::DICT_4X4_50, 3)},
        {.name = "square", .centre = {170, 180}, .depth_mm = depth_mm},
    };
  }
  StereoSight look() {
    return {bench::draw(scene, Side::left, random), bench::draw(scene, Side::right, random), model};
  }
  Result<LearnedSample> learn(const std::string& name, cv::Point2d click) {
    MarkLearner learner(name, click, objects);
    while (!learner.done()) {
      StereoSight sight = look();
      const Result<void> fed = learner.feed(sight);
      if (!fed) return fail(fed);
    }
    LearnedSample sample = learner.sample();
    sample.number = 1;
    return sample;
  }
  void learn_all() {
    for (const bench::SceneMark& mark : scene.marks) {
      Result<LearnedSample> sample = learn(mark.name, mark.centre + cv::Point2d(3, 2));
      ASSERT_TRUE(sample) << mark.name << ": " << sample.error().sentence;
      objects.add(mark.name, std::move(*sample));
    }
  }

  static constexpr double depth_mm = 500;
  static constexpr double tag_side_mm = 44;
  bench::Scene scene;
  Random random{9};
  camera::StereoModel model = bench::scene_camera();
  LearnedObjects objects;
  Time now = {};
};

// The eyes count the contour's rows from the top of the box.
TEST_F(Tags, HaveTheirContourWithinTheirBoxWhereverInAPixelTheirCornersAre) {
  const cv::Point2d first = scene.marks.front().centre;
  for (const double right : {0.0, 0.2, 0.4, 0.6, 0.8}) {
    for (const double down : {0.0, 0.2, 0.4, 0.6, 0.8}) {
      SCOPED_TRACE(testing::Message() << right << ' ' << down);
      scene.marks.front().centre = first + cv::Point2d(right, down);
      const Result<std::optional<SeenMark>> seen = tag_at(bench::draw(scene, Side::left, random), first);
      ASSERT_TRUE(seen && *seen);
      EXPECT_EQ(cv::boundingRect((*seen)->contour), (*seen)->box);
    }
  }
}

// A telephone's: of 12 million pixels.
TEST(TagsInAPhotograph, AreReadWhereTheyAreClickedOnHoweverLargeTheyAre) {
  const cv::Mat1b cells = cells_of(cv::aruco::DICT_APRILTAG_36h11, 17);
  for (const int side_px : {40, 120, 240, 360, 600, 1200, 2200}) {
    cv::Mat1b dark;
    cv::resize(cells, dark, {side_px, side_px}, 0, 0, cv::INTER_NEAREST);
    for (const cv::Point middle : {cv::Point(2003, 1501), cv::Point(1301, 1402)}) {
      cv::Mat1b image(3000, 4000, std::uint8_t{170});
      const cv::Rect place(middle - cv::Point(side_px / 2, side_px / 2), dark.size());
      image(place).setTo(30, dark);
      cv::GaussianBlur(image, image, {}, 1);
      for (const double beside : {0.0, 0.45}) {
        const cv::Point2d click = cv::Point2d(middle) + cv::Point2d(beside, -beside) * side_px;
        EXPECT_EQ(read_at(image, click), "apriltag-36h11-17") << side_px << " px, clicked at " << click;
      }
    }
  }
}

TEST_F(Tags, AreCalledByTheirFamilyAndNumber) {
  const Tag tag{"apriltag-36h11", 17};
  EXPECT_EQ(tag_name(tag), "apriltag-36h11-17");
  EXPECT_EQ(tag_called("apriltag-36h11-17"), tag);
  for (const char* none : {"dark", "apriltag-36h11-", "apriltag-36h11-x", "apriltag-99h9-1", "apriltag-36h11--1", ""}) {
    EXPECT_FALSE(tag_called(none)) << none;
  }
}

TEST_F(Tags, AClickInsideOneTellsWhichItIs) {
  const cv::Mat1b left = bench::draw(scene, Side::left, random);
  const std::optional<SeenMark> a = tag_at(left, {115, 75}).value();
  ASSERT_TRUE(a);
  EXPECT_EQ(tag_name(*a->tag), "apriltag-36h11-17");
  EXPECT_LT(cv::norm(a->centre - scene.marks[0].centre), 0.5);
  const std::optional<SeenMark> b = tag_at(left, {205, 85}).value();
  ASSERT_TRUE(b);
  EXPECT_EQ(tag_name(*b->tag), "aruco-4x4-50-3");
  EXPECT_EQ(read_at(left, {170, 180}), "none") << "a plain square";
  EXPECT_EQ(read_at(left, {20, 20}), "none") << "the ground";
}

TEST_F(Tags, AreReadWhereverOneClicksInThem) {
  struct Family {
    std::string name;
    cv::aruco::PREDEFINED_DICTIONARY_NAME dictionary;
    std::vector<int> numbers;
  };
  std::vector<Family> families = {
      {"apriltag-36h11", cv::aruco::DICT_APRILTAG_36h11, std::vector<int>(campaign(20, 100))},
      {"apriltag-36h10", cv::aruco::DICT_APRILTAG_36h10, {0, 99, 1000, 2319}},
      {"apriltag-25h9", cv::aruco::DICT_APRILTAG_25h9, {0, 9, 20, 34}},
      {"apriltag-16h5", cv::aruco::DICT_APRILTAG_16h5, {0, 1, 15, 29}},
      {"aruco-4x4-50", cv::aruco::DICT_4X4_50, {0, 3, 17, 49}},
      {"aruco-5x5-50", cv::aruco::DICT_5X5_50, {0, 3, 17, 49}},
      {"aruco-6x6-50", cv::aruco::DICT_6X6_50, {0, 3, 17, 49}},
      {"aruco-7x7-50", cv::aruco::DICT_7X7_50, {0, 3, 17, 49}},
      {"aruco-4x4-1000", cv::aruco::DICT_4X4_1000, {50, 99, 500, 999}},
      {"aruco-5x5-1000", cv::aruco::DICT_5X5_1000, {50, 99, 500, 999}},
      {"aruco-6x6-1000", cv::aruco::DICT_6X6_1000, {50, 99, 500, 999}},
      {"aruco-7x7-1000", cv::aruco::DICT_7X7_1000, {50, 99, 500, 999}},
      {"aruco-original", cv::aruco::DICT_ARUCO_ORIGINAL, {0, 1, 7, 100, 500, 1022, 1023}},
  };
  std::iota(families[0].numbers.begin(), families[0].numbers.end(), 0);
  constexpr double sides_px[] = {32, 56, 110};
  constexpr double inside = 0.47;  // of a side, from the middle
  std::size_t drawn = 0;
  for (const Family& family : families) {
    for (const int number : family.numbers) {
      const double side_px = sides_px[drawn++ % std::size(sides_px)];
      scene.marks = {{.name = "tag",
                      .centre = {165, 115},
                      .depth_mm = tag_side_mm * model.focal_px / side_px,
                      .turn_deg = random.uniform(-180, 180),
                      .tag = cells_of(family.dictionary, number)}};
      const cv::Mat1b image = bench::draw(scene, Side::left, random);
      std::vector<cv::Point2d> clicks = {{0, 0}};
      while (clicks.size() < 6) clicks.emplace_back(random.uniform(-inside, inside), random.uniform(-inside, inside));
      const double turn = scene.marks[0].turn_deg * CV_PI / 180;
      const cv::Matx22d turned(std::cos(turn), -std::sin(turn), std::sin(turn), std::cos(turn));
      for (const cv::Point2d& click : clicks) {
        const cv::Point2d at = scene.marks[0].centre + turned * click * side_px;
        EXPECT_EQ(read_at(image, at), tag_name({family.name, number}))
            << side_px << " px wide, clicked " << click << " of it off its middle";
      }
    }
  }
}

TEST_F(Tags, OneThatIsTooSmallToBeReadIsNotReadAsAnother) {
  for (int number = 0; number < 100; ++number) {
    const double side_px = random.uniform(12, 22);
    scene.marks = {{.name = "tag",
                    .centre = {165, 115},
                    .depth_mm = tag_side_mm * model.focal_px / side_px,
                    .turn_deg = random.uniform(-180, 180),
                    .tag = cells_of(cv::aruco::DICT_6X6_1000, 500 + number)}};
    const std::string read = read_at(bench::draw(scene, Side::left, random), scene.marks[0].centre);
    EXPECT_TRUE(read == "none" || read == tag_name({"aruco-6x6-1000", 500 + number})) << read << ", " << side_px;
  }
}

TEST_F(Tags, AreFollowedToWhereTheyWouldBeFoundAlsoInSlantedLight) {
  int found = 0;
  for (int number = 0; number < 60; ++number) {
    const Tag tag{"apriltag-36h11", number};
    scene.light.slope_per_px = {random.uniform(-0.004, 0.004), random.uniform(-0.004, 0.004)};
    scene.marks = {{.name = "tag",
                    .centre = {165, 115},
                    .depth_mm = tag_side_mm * model.focal_px / random.uniform(24, 90),
                    .turn_deg = random.uniform(-180, 180),
                    .tag = cells_of(cv::aruco::DICT_APRILTAG_36h11, number)}};
    const cv::Mat1b image = bench::draw(scene, Side::left, random);
    const std::vector<SeenMark> there = find_tags(image, tag);
    if (there.empty()) continue;
    ++found;
    const cv::Point moved(cvRound(random.uniform(-8, 8)), cvRound(random.uniform(-8, 8)));
    const std::vector<SeenMark> followed = follow_tag(image, tag, area_around_tag(there.front().box + moved));
    ASSERT_EQ(followed.size(), 1U) << number;
    EXPECT_LT(cv::norm(followed.front().centre - scene.marks[0].centre), 0.3) << number;
    EXPECT_NEAR(followed.front().height_px, there.front().height_px, 0.02 * there.front().height_px) << number;
  }
  EXPECT_GT(found, 50);
}

TEST_F(Tags, AreLearnedFoundAndTrackedLikeOtherMarks) {
  learn_all();
  ASSERT_TRUE(objects.find("a")->tag());
  EXPECT_FALSE(objects.find("square")->tag());
  scene.marks[0].centre += cv::Point2d(25, 10);
  scene.marks[0].turn_deg = 35;
  MarkTracker tracker(objects);
  for (const bench::SceneMark& mark : scene.marks) ASSERT_TRUE(tracker.add(*objects.find(mark.name)));
  for (int frame = 0; frame < 3; ++frame) {
    StereoSight sight = look();
    const std::vector<TrackSighting> seen = tracker.update(sight, now += 100ms);
    for (std::size_t i = 0; i < scene.marks.size(); ++i) {
      ASSERT_TRUE(seen[i].seen) << seen[i].name;
      EXPECT_LT(cv::norm(seen[i].centre - scene.marks[i].centre), 0.5) << seen[i].name;
      const double expected = range_at_depth_mm(model, scene.marks[i].centre, depth_mm);
      EXPECT_NEAR(seen[i].range_mm, expected, 0.01 * expected) << seen[i].name;
    }
  }
}

TEST_F(Tags, WhileItIsTrackedOneIsLookedForWhereItWasSoThatAnotherOfItsNumberDoesNotDrawItAway) {
  learn_all();
  MarkTracker tracker(objects);
  ASSERT_TRUE(tracker.add(*objects.find("a")));
  StereoSight alone = look();
  ASSERT_TRUE(tracker.update(alone, now).front().seen);
  scene.marks.push_back(scene.marks[0]);
  for (const cv::Point2d& other : {cv::Point2d(250, 190), cv::Point2d(255, 30)}) {
    scene.marks.back().centre = other;
    scene.marks[0].centre += cv::Point2d(3, 2);
    StereoSight sight = look();
    const TrackSighting seen = tracker.update(sight, now += 100ms).front();
    EXPECT_LT(cv::norm(seen.centre - scene.marks[0].centre), 0.5);
  }
}

TEST_F(Tags, OneThatIsThereTwiceIsNeither) {
  learn_all();
  scene.marks.push_back(scene.marks[0]);
  scene.marks.back().centre = {250, 190};
  StereoSight sight = look();
  EXPECT_FALSE(sight.find(objects, *objects.find("a")));
  EXPECT_TRUE(sight.find(objects, *objects.find("b")));
  MarkTracker tracker(objects);
  ASSERT_TRUE(tracker.add(*objects.find("a")));
  EXPECT_FALSE(tracker.update(sight, now).front().seen);
  scene.marks.pop_back();
  StereoSight alone = look();
  EXPECT_TRUE(tracker.update(alone, now += 100ms).front().seen);
}

TEST_F(Tags, AnotherOfItsNumberIsNotTakenForOneThatIsHidden) {
  learn_all();
  MarkTracker tracker(objects);
  ASSERT_TRUE(tracker.add(*objects.find("a")));
  StereoSight alone = look();
  ASSERT_TRUE(tracker.update(alone, now).front().seen);
  const bench::SceneMark tracked = scene.marks[0];
  scene.marks.push_back(tracked);
  scene.marks.back().centre = {250, 190};
  StereoSight both = look();
  EXPECT_TRUE(tracker.update(both, now += 100ms).front().seen);
  scene.marks.erase(scene.marks.begin());
  for (int frame = 0; frame < 10; ++frame) {
    StereoSight other = look();
    EXPECT_FALSE(tracker.update(other, now += 100ms).front().seen) << frame;
  }
  scene.marks.push_back(tracked);
  StereoSight back = look();
  const TrackSighting again = tracker.update(back, now += 100ms).front();
  ASSERT_TRUE(again.seen);
  EXPECT_LT(cv::norm(again.centre - tracked.centre), 0.5);
}

TEST_F(Tags, ATagThatIsNotThereIsNotFoundInAnother) {
  learn_all();
  scene.marks.erase(scene.marks.begin());
  StereoSight sight = look();
  EXPECT_FALSE(sight.find(objects, *objects.find("a")));
  EXPECT_TRUE(sight.find(objects, *objects.find("b")));
}

// A strip along its border leaves a smaller square in which the cells can still be read; inside are light shapes too.
TEST_F(Tags, AClickIntoOneThatIsPartlyHiddenTeachesNothingElse) {
  scene.marks = {{.name = "tag",
                  .centre = {165, 115},
                  .depth_mm = tag_side_mm * model.focal_px / 110,
                  .tag = cells_of(cv::aruco::DICT_ARUCO_ORIGINAL, 1023)}};
  scene.things = {{.shape = bench::placed(bench::box(7, 140), {165 - 53, 115}, 1, 0),
                   .level = 160,
                   .depth_mm = scene.marks[0].depth_mm,
                   .in_front = true}};
  const Result<LearnedSample> sample = learn("tag", scene.marks[0].centre);
  ASSERT_FALSE(sample) << tone_of(*sample);
  EXPECT_EQ(sample.error().symbol, "unclear-tag") << sample.error().sentence;
}

TEST_F(Tags, ATagOfAnotherNameIsNotLearnedTwice) {
  learn_all();
  const Result<LearnedSample> again = learn("c", scene.marks[0].centre);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().symbol, "ambiguous");
}

TEST_F(Tags, UnderOneNameASampleOfAnotherKindIsRefused) {
  learn_all();
  const auto refused = [&](const std::string& name, std::size_t mark) {
    const Result<LearnedSample> sample = learn(name, scene.marks[mark].centre);
    return sample ? "" : sample.error().symbol + ": " + sample.error().sentence;
  };
  EXPECT_EQ(refused("Square", 0), "other-kind: a shape is learned under this name, and this is a tag");
  EXPECT_EQ(refused("a", 2), "other-kind: a tag is learned under this name, and this is a shape");
  EXPECT_EQ(refused("a", 1), "other-kind: another tag is learned under this name, apriltag-36h11-17");
  EXPECT_EQ(refused("A", 0), "");
  EXPECT_EQ(refused("square", 2), "");
}

TEST_F(Tags, ARestartedAgentKnowsThemFromItsFacts) {
  learn_all();
  const LearnedSample& sample = objects.find("b")->samples.front();
  const Result<LearnedSample> read = sample_from_facts(facts_of_sample("b", sample));
  ASSERT_TRUE(read) << read.error().sentence;
  EXPECT_EQ(read->tag, (Tag{"aruco-4x4-50", 3}));
}

}  // namespace
}  // namespace pizarra::vision
