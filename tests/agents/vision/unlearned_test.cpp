// Shapes that nobody learned, beside those that are.

#include "tests/bench/vision/unlearned.hpp"

#include <gtest/gtest.h>
#include <map>

#include "agents/vision/sight/mark_finder.hpp"
#include "agents/vision/sight/wholeness.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/bench/vision/scene.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

const cv::Point2d mark_place(150, 120);
const cv::Point2d other_place(190, 120);

// A learned mark, and to the right of it, larger, a shape that nobody learned.
bench::Scene scene_with(const std::string& mark, const bench::Shape& other) {
  bench::Scene scene;
  scene.marks = {{.name = mark, .centre = mark_place}};
  const double scale = 1.15 * bench::scale_at(bench::learning_depth_mm);
  scene.things = {{.shape = bench::placed(other, other_place, scale, 5), .level = scene.mark_level}};
  return scene;
}

camera::StereoModel one_camera() {
  camera::StereoModel model = bench::scene_camera();
  model.base_line_mm = 0;
  return model;
}

// In the light and the sharpness of a lab; what noise and blur may do to it bench/vision's row `unlearned` counts.
TEST(Unlearned, AloneIsNothing) {
  const cv::Mat nothing = cv::Mat::zeros(240, 320, CV_8UC1);
  const camera::StereoModel model = one_camera();
  for (const bench::UnlearnedShape& shape : bench::unlearned_shapes()) {
    if (!shape.no_view_of_a_mark) continue;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      SCOPED_TRACE(testing::Message() << shape.name << ", seed " << seed);
      Random random(seed);
      bench::Scene scene;
      const cv::Point2d place(random.uniform(80, 240), random.uniform(60, 180));
      const double scale = random.uniform(1, 1.5) * bench::scale_at(bench::learning_depth_mm);
      scene.things = {
          {.shape = bench::placed(shape.shape, place, scale, random.uniform(0, 360)), .level = scene.mark_level}};
      StereoSight sight(draw(scene, bench::Side::left, random), nothing, model);
      for (const LearnedObject& object : learned_cell().all()) {
        EXPECT_FALSE(sight.find(learned_cell(), object)) << "taken for the " << object.name;
      }
    }
  }
}

// In any light, noise, blur and size of the bench's scenes, where it may pass for a learned one.
TEST(Unlearned, ThatPassesForACircleIsHardlyEverSureToBeOne) {
  constexpr int scenes = 400;
  constexpr double sure_from = 0.9;
  const LearnedObject& circle = *learned_cell().find("circle");
  for (const bench::UnlearnedShape& shape : bench::unlearned_shapes()) {
    if (shape.name != std::string("hexagon") && shape.name != std::string("heptagon")) continue;
    int sure = 0;
    for (int i = 0; i < scenes; ++i) {
      Random random(static_cast<std::uint64_t>(i));
      bench::SceneRanges ranges = bench::hard_ranges;
      ranges.presence = ranges.most_clutter = 0;
      bench::Scene scene = random_scene(ranges, random);
      const cv::Point2d place(random.uniform(60, 260), random.uniform(60, 180));
      const double scale = random.uniform(0.6, 1.6) * bench::scale_at(bench::learning_depth_mm);
      const double turn = random.uniform(0, 360);
      scene.things = {{.shape = bench::placed(shape.shape, place, scale, turn), .level = scene.mark_level}};
      ImageSegmentation segmentation(draw(scene, bench::Side::left, random));
      const SeenMark* seen = find_object(segmentation.marks(), learned_cell(), circle);
      sure += seen != nullptr && likeness(*seen, learned_cell(), circle).confidence() >= sure_from ? 1 : 0;
    }
    EXPECT_LE(sure, scenes / 100) << shape.name;
  }
}

// One shape as wide as 20 px or more, in any light, noise and blur of the bench's scenes.
cv::Mat image_of_one(const bench::Shape& shape, std::uint64_t seed) {
  Random random(seed);
  bench::SceneRanges ranges = bench::hard_ranges;
  ranges.presence = ranges.most_clutter = 0;
  bench::Scene scene = random_scene(ranges, random);
  const cv::Point2d place(random.uniform(60, 260), random.uniform(60, 180));
  const double scale = random.uniform(0.95, 1.6) * bench::scale_at(bench::learning_depth_mm);
  scene.things = {{.shape = bench::placed(shape, place, scale, random.uniform(0, 360)), .level = scene.mark_level}};
  return draw(scene, bench::Side::left, random);
}

struct TimesFound {
  int found = 0;
  int surely = 0;
};

TimesFound times_found(const bench::Shape& shape, const std::string& name, int scenes) {
  constexpr double sure_from = 0.9;
  const camera::StereoModel model = one_camera();
  TimesFound out;
  for (int i = 0; i < scenes; ++i) {
    const cv::Mat image = image_of_one(shape, static_cast<std::uint64_t>(i));
    StereoSight sight(image, image, model);
    const Result<FoundMark> found = MarkFinder(learned_cell()).find(sight, *learned_cell().find(name), {});
    out.found += found ? 1 : 0;
    out.surely += found && found->confidence >= sure_from ? 1 : 0;
  }
  return out;
}

// The edges tell: a polygon's go around a circle's in a wave, and where a square has corners those of a rounded one are
// off. A part of a mark may be like a part of anything.
TEST(Unlearned, ThatIsWideIsNotFoundWhereItsEdgesShowAnotherOutline) {
  const int scenes = campaign(100, 3000);
  const std::map<std::string, std::pair<std::string, double>> taken_for = {{"heptagon", {"circle", 0.03}},
                                                                           {"octagon", {"circle", 0.06}},
                                                                           {"rounded square", {"square", 0.04}},
                                                                           {"trapezoid", {"square", 0.25}}};
  for (const auto& [shape, taken] : taken_for) {
    const auto unlearned = std::ranges::find(bench::unlearned_shapes(), shape, &bench::UnlearnedShape::name);
    ASSERT_NE(unlearned, bench::unlearned_shapes().end()) << shape;
    const auto& [name, share] = taken;
    const TimesFound times = times_found(unlearned->shape, name, scenes);
    EXPECT_LE(times.found, share * scenes) << shape;
    EXPECT_LE(times.surely, scenes / 1000) << shape;
  }
}

TEST(Unlearned, OutlineIsNotSeenInALearnedMarkThatIsWide) {
  const int scenes = campaign(100, 2000);
  for (const std::string name : {"circle", "square", "cross", "triangle"}) {
    EXPECT_GE(times_found(bench::mark_shape(name), name, scenes).found, 0.98 * scenes) << name;
  }
}

cv::Point2d place_in_view(Random& random) { return cv::Point2d(random.uniform(60, 260), random.uniform(60, 180)); }

bench::Shape small_ring(Random& random) {
  bench::Shape ring = bench::disc(0.5);
  ring.push_back(bench::disc(0.5 * random.uniform(0.5, 0.8)).front());
  std::ranges::reverse(ring.back());
  const cv::Point2d place = place_in_view(random);
  return bench::placed(ring, place, random.uniform(9, 16), 0);
}

// Six corners, of which blur leaves three.
bench::Shape small_angle(Random& random) {
  const double t = random.uniform(0.25, 0.35) - 0.4;
  const bench::Shape angle = {{{-0.4, -0.4}, {0.4, -0.4}, {0.4, t}, {t, t}, {t, 0.4}, {-0.4, 0.4}}};
  const cv::Point2d place = place_in_view(random);
  return bench::placed(angle, place, random.uniform(10, 16), random.uniform(0, 360));
}

// How often a shape that is alone is taken for a learned one: in any light and noise, and as blurred as the bench's
// scenes at their worst.
int times_taken(bench::Shape (*shape)(Random&), int scenes) {
  int taken = 0;
  for (int i = 0; i < scenes; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    bench::SceneRanges ranges = bench::hard_ranges;
    ranges.presence = ranges.most_clutter = 0;
    ranges.least_blur_px = 1;
    bench::Scene scene = random_scene(ranges, random);
    scene.things = {{.shape = shape(random), .level = random.uniform(10, 120)}};
    ImageSegmentation segmentation(draw(scene, bench::Side::left, random));
    for (const LearnedObject& object : learned_cell().all()) {
      taken += find_object(segmentation.marks(), learned_cell(), object) != nullptr ? 1 : 0;
    }
  }
  return taken;
}

// What is smaller than most learned marks.
TEST(Unlearned, RingWhoseHoleIsBlurredIsHardlyEverADisc) {
  const int scenes = campaign(400, 1000);
  EXPECT_LE(times_taken(small_ring, scenes), scenes / 200);
}

// As small as a learned triangle is sought.
TEST(Unlearned, SmallAngleIsHardlyEverATriangle) {
  const int scenes = campaign(800, 4000);
  EXPECT_LE(times_taken(small_angle, scenes), scenes / 50);
}

// FIND's confidence in one shape in a lab's light, before one camera or a pair; nothing where it finds nothing.
double confidence_of(const bench::Shape& shape, const std::string& name, bool pair, std::uint64_t seed) {
  Random random(seed);
  bench::Scene scene;
  const double depth_mm = bench::learning_depth_mm / random.uniform(1, 1.5);
  const cv::Point2d place(random.uniform(140, 250), random.uniform(60, 180));
  scene.things = {{.shape = bench::placed(shape, place, bench::scale_at(depth_mm), random.uniform(-30, 30)),
                   .level = scene.mark_level,
                   .depth_mm = depth_mm}};
  const cv::Mat left = draw(scene, bench::Side::left, random);
  const camera::StereoModel model = pair ? bench::scene_camera() : one_camera();
  StereoSight sight(left, pair ? draw(scene, bench::Side::right, random) : left, model);
  const LearnedObject& object = *learned_cell().find(name);
  const std::optional<SeenPair> found = sight.find(learned_cell(), object);
  return found ? confidence_in_look(sight, object, *found) : 0;
}

// A parallelogram is a square seen aslant and an ellipse a circle; what faces the camera is what it looks like.
TEST(Unlearned, ThatIsAViewOfALearnedOneIsNotSureAndWhatFacesTheCameraIs) {
  const auto shape = [](const std::string& name) {
    return std::ranges::find(bench::unlearned_shapes(), name, &bench::UnlearnedShape::name)->shape;
  };
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    for (const bool pair : {false, true}) {
      SCOPED_TRACE(testing::Message() << (pair ? "a pair, " : "one camera, ") << "seed " << seed);
      EXPECT_LT(confidence_of(shape("parallelogram"), "square", pair, seed), 0.9);
      EXPECT_LT(confidence_of(shape("ellipse"), "circle", pair, seed), 0.9);
      // Before one camera it is a square that was badly cut.
      if (pair) {
        EXPECT_LT(confidence_of(shape("rounded square"), "square", pair, seed), 0.9);
      }
      for (const std::string name : {"square", "circle"}) {
        EXPECT_GT(confidence_of(bench::mark_shape(name), name, pair, seed), 0.9) << name;
      }
    }
  }
}

TEST(Unlearned, BesideALearnedMarkIsNotTakenForItAndNotKeptQuietAboutEither) {
  const camera::StereoModel pair = bench::scene_camera();
  for (const bench::UnlearnedShape& other : bench::unlearned_shapes()) {
    if (!other.no_view_of_a_mark) continue;
    for (const std::string mark : {"circle", "square"}) {
      for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        SCOPED_TRACE(mark + " beside a " + other.name);
        Random random(seed);
        const bench::Scene scene = scene_with(mark, other.shape);
        const cv::Mat left = draw(scene, bench::Side::left, random);
        const cv::Mat right = draw(scene, bench::Side::right, random);
        const LearnedObject& object = *learned_cell().find(mark);
        for (const camera::StereoModel& model : {one_camera(), pair}) {
          StereoSight sight(left, model.is_single() ? left : right, model);
          const std::optional<SeenPair> found = sight.find(learned_cell(), object);
          ASSERT_TRUE(found) << (model.is_single() ? "one camera" : "a pair");
          EXPECT_LT(cv::norm(found->left.centre - mark_place), 0.5) << (model.is_single() ? "one camera" : "a pair");
          std::vector<SeenMark> marks = sight.left_segmentation().marks();
          const auto beside =
              std::ranges::find_if(marks, [](const SeenMark& seen) { return cv::norm(seen.centre - other_place) < 5; });
          ASSERT_NE(beside, marks.end());
          const bool alike = is_recognised(*beside, learned_cell(), object);
          EXPECT_EQ(others_like(marks, learned_cell(), object, found->left).size(), alike ? 1U : 0U);
        }
      }
    }
  }
}

}  // namespace
}  // namespace pizarra::vision
