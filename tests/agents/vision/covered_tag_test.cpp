// A hand, light or dark, slides over a tag, rests and leaves: along a side and from anywhere, slowly and fast, before
// one camera and before a pair. Where a tag is told or found, there it is.

#include <gtest/gtest.h>
#include <opencv2/aruco.hpp>

#include "agents/vision/sight/mark_learner.hpp"
#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/falling_shadow.hpp"
#include "tests/bench/vision/scene.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

using bench::Side;

struct TagHand {
  double from_deg;
  double speed_px;  // a frame
  double level;
  double depth_share;  // of the tag's depth
};

class CoveredTag : public testing::TestWithParam<std::tuple<int, int>> {
 protected:
  static constexpr double most_off_px = 2;
  static constexpr double sure_from = 0.9;
  static constexpr double most_off_sure_px = 1;
  static constexpr int frames_at_rest = 10;

  CoveredTag() : random(Random(std::get<1>(GetParam())).split("covered tag")) {
    const auto family = static_cast<cv::aruco::PREDEFINED_DICTIONARY_NAME>(std::get<0>(GetParam()));
    const cv::Ptr<cv::aruco::Dictionary> dictionary = cv::aruco::getPredefinedDictionary(family);
    cv::Mat drawn;
    dictionary->drawMarker(random.below(dictionary->bytesList.rows), dictionary->markerSize + 2, drawn);
    const double depth_mm = random.uniform(280, 700);
    const double reach = 44 * bench::scale_at(depth_mm);
    scene.marks = {{.name = "tag",
                    .centre = {random.uniform(bench::disparity_px(depth_mm) + reach, model.width - reach),
                               random.uniform(reach, model.height - reach)},
                    .depth_mm = depth_mm,
                    .turn_deg = random.uniform(-45, 45),
                    .tag = drawn == 0}};
    scene.noise = random.uniform(1, 6);
    scene.blur_px = random.uniform(0.5, 1);
    learn();
  }
  void learn() {
    MarkLearner learner("tag", mark().centre, objects);
    while (!learner.done()) {
      StereoSight sight = look_with_both();
      const Result<void> fed = learner.feed(sight);
      if (!fed) throw std::runtime_error(fed.error().sentence);
    }
    LearnedSample sample = learner.sample();
    sample.number = 1;
    objects.add("tag", std::move(sample));
    for (MarkTracker* each : {&pair, &single}) EXPECT_TRUE(each->add(*objects.find("tag")));
  }

  const bench::SceneMark& mark() const { return scene.marks.front(); }
  double side_px() const { return 44 * bench::scale_at(mark().depth_mm); }
  StereoSight look_with_both() {
    const cv::Mat1b left = bench::draw(scene, Side::left, random);
    const cv::Mat1b right = bench::draw(scene, Side::right, random);
    if (shadow) shadow->fall(left, mark().centre);
    if (shadow) shadow->fall(right, mark().centre - cv::Point2d(bench::disparity_px(mark().depth_mm), 0));
    return {left, right, model};
  }
  void look() {
    StereoSight both = look_with_both();
    StereoSight left_only(both.left(), cv::Mat1b::zeros(both.left().size()), alone);
    now += 100ms;
    seen_by_pair = is_seen(pair.update(both, now).front());
    seen_by_one = is_seen(single.update(left_only, now).front());
    const std::optional<SeenPair> found = both.find(objects, *objects.find("tag"));
    if (found) check(found->left.centre, found->likeness.confidence());
  }
  bool is_seen(const TrackSighting& sighting) {
    if (!sighting.seen) return false;
    check(sighting.centre, sighting.confidence);
    return true;
  }
  void check(cv::Point2d told, double confidence) {
    ++positions;
    sure += confidence < sure_from ? 0 : 1;
    EXPECT_LT(cv::norm(told - mark().centre), confidence < sure_from ? most_off_px : most_off_sure_px) << confidence;
    if (scene.things.empty() && !shadow) {
      EXPECT_GT(confidence, sure_from) << "of a whole one";
    }
  }
  void look_on(int frames) {
    for (int n = 0; n < frames; ++n) look();
    EXPECT_TRUE(seen_by_pair) << "by the pair";
    EXPECT_TRUE(seen_by_one) << "by one camera";
  }
  void put_hand(const TagHand& hand, double edge_px) {
    const double wide = 3 * side_px();
    const double from = hand.from_deg * CV_PI / 180;
    const cv::Point2d middle = mark().centre + (edge_px + wide / 2) * cv::Point2d(std::cos(from), std::sin(from));
    scene.things = {{.shape = bench::placed(bench::box(wide, wide), middle, 1, hand.from_deg),
                     .level = hand.level,
                     .depth_mm = hand.depth_share * mark().depth_mm,
                     .in_front = true}};
  }
  void slide(const TagHand& hand, double from_px, double to_px) {
    const double step = from_px < to_px ? hand.speed_px : -hand.speed_px;
    for (double edge = from_px; (to_px - edge) * step > 0; edge += step) {
      SCOPED_TRACE(testing::Message() << "its edge " << edge << " px from the centre");
      put_hand(hand, edge);
      look();
    }
  }
  TagHand random_hand() {
    const double levels[] = {25, 60, 95, 140, 160, 190, 225};
    const double side = mark().turn_deg + 90.0 * static_cast<double>(random.below(4));
    return {random.below(2) == 0 ? side : random.uniform(0, 360),
            random.below(2) == 0 ? random.uniform(0.7, 2) : random.uniform(4, 10), levels[random.below(7)],
            random.below(2) == 0 ? 0.98 : 0.85};
  }

  Random random;
  const camera::StereoModel model = bench::scene_camera();
  const camera::StereoModel alone = [] {
    camera::StereoModel out = bench::scene_camera();
    out.base_line_mm = 0;
    out.learned_at_mm = 500;
    return out;
  }();
  bench::Scene scene;
  std::optional<Shadow> shadow = {};
  LearnedObjects objects;
  Time now = {};
  MarkTracker pair{objects};
  MarkTracker single{objects};
  int positions = 0;
  int sure = 0;
  bool seen_by_pair = false;
  bool seen_by_one = false;
};

TEST_P(CoveredTag, IsToldWhereItIsOrNotAtAll) {
  look_on(4);
  for (int n = 0; n < campaign(2, 4); ++n) {
    const TagHand hand = random_hand();
    SCOPED_TRACE(testing::Message() << side_px() << " px wide, turned by " << mark().turn_deg << ", a hand from "
                                    << hand.from_deg << " degrees at " << hand.speed_px << " px a frame, level "
                                    << hand.level << " at " << hand.depth_share << " of its depth");
    const double reach = 0.75 * side_px();
    const double rests_at = random.uniform(-0.1, 0.5) * side_px();
    slide(hand, reach, rests_at);
    for (int frame = 0; frame < frames_at_rest; ++frame) look();
    slide(hand, rests_at, -reach);
    EXPECT_FALSE(seen_by_pair || seen_by_one);
    slide(hand, -reach, reach);
    scene.things.clear();
    look_on(2);
  }
}

// That hides nothing of it.
TEST_P(CoveredTag, AcrossWhichAShadowFallsIsSure) {
  look_on(2);
  positions = sure = 0;
  constexpr int shadows = 12;
  for (int n = 0; n < shadows; ++n) {
    shadow = {random.uniform(0, 360), random.uniform(-0.7, 0.7) * side_px(), random.uniform(0.5, 0.8)};
    look();
  }
  EXPECT_GE(positions, 2 * shadows);
  EXPECT_GE(sure, 0.8 * positions) << "of " << positions;
}

std::string instance_name(const testing::TestParamInfo<CoveredTag::ParamType>& one) {
  const bool four_by_four = std::get<0>(one.param) == cv::aruco::DICT_4X4_50;
  return (four_by_four ? "Aruco4x4n" : "AprilTag36h11n") + std::to_string(std::get<1>(one.param));
}

INSTANTIATE_TEST_SUITE_P(Seeds, CoveredTag,
                         testing::Combine(testing::Values<int>(cv::aruco::DICT_4X4_50, cv::aruco::DICT_APRILTAG_36h11),
                                          testing::Range(1, campaign(3, 5))),
                         instance_name);

}  // namespace
}  // namespace pizarra::vision
