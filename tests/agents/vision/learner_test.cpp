#include <functional>
#include <gtest/gtest.h>

#include "tests/agents/vision/eyes.hpp"

namespace pizarra::vision {
namespace {

const cv::Point3d in_front(0, 0, 850);

Scene circle_scene() {
  Scene scene;
  scene.faces = {{.mark = "circle", .place = in_front}};
  return scene;
}

std::string failure_of(const Scene& scene, cv::Point2d click, const std::string& name = "new",
                       const LearnedObjects& objects = LearnedObjects()) {
  Random random(1);
  MarkLearner learner(name, click, objects);
  const Result<LearnedSample> sample = learn_from(scene, learner, random);
  return sample ? "none" : sample.error().symbol;
}

TEST(Learner, TakesTenFramesToFillAndTenToFollow) {
  Random random(2);
  const LearnedObjects none;
  MarkLearner learner("circle", project(DrawnSight::model(), in_front, false), none);
  int filled_px = 0;
  for (int frame = 1; frame <= 20; ++frame) {
    EXPECT_FALSE(learner.done());
    DrawnSight drawn(circle_scene(), random);
    ASSERT_TRUE(learner.feed(drawn.sight));
    EXPECT_EQ(learner.contour().empty(), frame < 10);
    if (frame > 10) continue;
    const int more_px = cv::countNonZero(learner.filled_so_far());
    EXPECT_GT(more_px, filled_px) << "the picture of it grows, frame " << frame;
    filled_px = more_px;
  }
  EXPECT_NEAR(filled_px, 391, 20) << "to the whole mark";
  EXPECT_TRUE(learner.done());
  const LearnedSample sample = learner.sample();
  EXPECT_NEAR(sample.area_px, 391, 10);
  EXPECT_NEAR(sample.size_mm, 11, 0.3);  // a circle's standard deviation is half its radius
}

TEST(Learner, SaysWhyAPlaceCannotBeLearned) {
  const Scene scene = circle_scene();
  const cv::Point2d centre = project(DrawnSight::model(), in_front, false);
  EXPECT_EQ(failure_of(scene, {-3, 20}), "outside");
  EXPECT_EQ(failure_of(scene, {320, 20}), "outside");
  EXPECT_EQ(failure_of(scene, {1e300, 20}), "outside");
  EXPECT_EQ(failure_of(scene, {40, 40}), "background");
  EXPECT_EQ(failure_of(scene, centre), "none");
}

TEST(Learner, RefusesTheFaceAroundTheMark) {
  const cv::Point2d corner = project(DrawnSight::model(), in_front + cv::Point3d(-26, -26, 0), false);
  EXPECT_EQ(failure_of(circle_scene(), corner), "background");
}

TEST(Learner, RefusesWhatReachesTheBorder) {
  Scene scene;
  scene.faces = {{.mark = "circle", .place = {0, -235, 850}}};
  const cv::Point2d seen = project(DrawnSight::model(), {0, -225, 850}, false);
  EXPECT_EQ(failure_of(scene, seen), "border");
}

// As on a sheet of paper: light ground that reaches the border, with marks on it.
TEST(Learner, RefusesTheGroundAroundMarksAtWhateverDistance) {
  Scene scene;
  scene.ground = 200;
  scene.blots = {{.box = {100, 80, 24, 24}, .level = 30}, {.box = {180, 120, 24, 24}, .level = 30}};
  for (const double off : {3.0, 8.0, 20.0, 60.0}) {
    EXPECT_EQ(failure_of(scene, {100 - off, 92}), "background") << off << " px beside a mark";
  }
  EXPECT_EQ(failure_of(scene, {112, 92}), "none");
}

TEST(Learner, RefusesAContourThatIsNotClosed) {
  Scene scene = circle_scene();
  const cv::Point2d centre = project(DrawnSight::model(), in_front, false);
  // A dark bar lets the fill leak over the face and out.
  scene.blots = {{.box = {centre.x, centre.y - 4, 30, 8}, .level = 25}};
  EXPECT_EQ(failure_of(scene, centre), "open-contour");
  // As thick as a pencil's line.
  scene.blots = {{.box = {centre.x, centre.y - 2, 30, 3}, .level = 25}};
  EXPECT_EQ(failure_of(scene, centre), "open-contour");
}

// Learns while `change` alters the scene before each frame after the tenth.
Result<void> learn_while(const std::function<void(Scene&)>& change) {
  Random random(3);
  Scene scene = circle_scene();
  const LearnedObjects none;
  MarkLearner learner("circle", project(DrawnSight::model(), in_front, false), none);
  Result<void> fed;
  for (int frame = 0; frame < 20 && fed; ++frame) {
    if (frame >= 10) change(scene);
    DrawnSight drawn(scene, random);
    fed = learner.feed(drawn.sight);
  }
  return fed;
}

TEST(Learner, FollowsAMarkThatMovesAndRefusesOneThatIsGone) {
  EXPECT_TRUE(learn_while([](Scene& scene) { scene.faces[0].place.x += 4; }));
  const Result<void> gone = learn_while([](Scene& scene) { scene.faces.clear(); });
  ASSERT_FALSE(gone);
  EXPECT_EQ(gone.error().symbol, "moved");
  const Result<void> other = learn_while([](Scene& scene) { scene.faces[0].mark = "cross"; });
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().symbol, "moved");
}

TEST(Learner, RefusesASecondNameForAKnownMarkButNotASecondSample) {
  const cv::Point2d centre = project(DrawnSight::model(), in_front, false);
  EXPECT_EQ(failure_of(circle_scene(), centre, "ball", learned_cell()), "ambiguous");
  EXPECT_EQ(failure_of(circle_scene(), centre, "Circle", learned_cell()), "none");
}

TEST(LearnedObjects, CountSamplesUnderTheFirstNameAndHaveBounds) {
  LearnedObjects objects;
  for (int i = 1; i <= static_cast<int>(most_samples); ++i) {
    const LearnedObjects::Slot slot = objects.slot_for(i == 1 ? "Circle" : "circle").value();
    EXPECT_EQ(slot.name, "Circle");
    EXPECT_EQ(slot.number, i);
    LearnedSample sample;
    sample.number = slot.number;
    objects.add(slot.name, sample);
  }
  EXPECT_EQ(objects.slot_for("CIRCLE").error().symbol, "full");
  EXPECT_TRUE(check_object_name("end-effector"));
  for (const std::string bad : {"", "9a", "-a", "a b", "a\"b", "a/b"}) EXPECT_FALSE(check_object_name(bad)) << bad;
}

}  // namespace
}  // namespace pizarra::vision
