#include "agents/vision/marks/tags.hpp"

#include <gtest/gtest.h>
#include <opencv2/aruco.hpp>

#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/scene.hpp"

namespace pizarra {
namespace {

using bench::Side;

cv::Mat1b cells_of(cv::aruco::PREDEFINED_DICTIONARY_NAME family, int number) {
  const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family);
  cv::Mat drawn;
  dictionary->drawMarker(number, dictionary->markerSize + 2, drawn);
  return drawn == 0;
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
  bench::Scene scene;
  Random random{9};
  StereoModel model = bench::scene_camera();
  LearnedObjects objects;
  Time now = {};
};

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
  const std::optional<SeenMark> a = tag_at(left, {115, 75});
  ASSERT_TRUE(a);
  EXPECT_EQ(tag_name(*a->tag), "apriltag-36h11-17");
  EXPECT_LT(cv::norm(a->centre - scene.marks[0].centre), 0.5);
  const std::optional<SeenMark> b = tag_at(left, {205, 85});
  ASSERT_TRUE(b);
  EXPECT_EQ(tag_name(*b->tag), "aruco-4x4-50-3");
  EXPECT_FALSE(tag_at(left, {170, 180})) << "a plain square is none";
  EXPECT_FALSE(tag_at(left, {20, 20})) << "nor is the ground";
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
  const Result<LearnedSample> read = sample_from_facts(learned_fact("b", sample), learned_template_fact("b", sample));
  ASSERT_TRUE(read) << read.error().sentence;
  EXPECT_EQ(read->tag, (Tag{"aruco-4x4-50", 3}));
}

}  // namespace
}  // namespace pizarra
