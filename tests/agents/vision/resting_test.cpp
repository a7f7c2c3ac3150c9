// A hand comes, rests over a part of a mark for half a minute or five, and leaves, at ten images a second and at sixty:
// meanwhile no position is told that is not the mark's, and when it has left the mark is seen again where it is.

#include "tests/agents/vision/covered_mark.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

constexpr int bright = 200;
constexpr int middle = 140;
constexpr int dark = 40;

struct Rest {
  int level;
  Duration duration;
  int rate;  // images a second
};

class Resting : public testing::TestWithParam<std::tuple<std::string, int>> {
 protected:
  Resting() { mark.most_off_px = 2; }
  // A hand that rests is drawn a few times only; its images come in turn.
  void look_for(Duration duration) {
    std::vector<camera::StereoFrame> frames;
    while (frames.size() < 20) frames.push_back(mark.draw());
    const auto count = duration * mark.rate / 1s;
    for (int n = 0; n < count && !testing::Test::HasFailure(); ++n) {
      SCOPED_TRACE(testing::Message() << "frame " << n << " of " << count);
      mark.look(frames[mark.random.below(frames.size())]);
    }
  }
  Hand hand_for(const Rest& rest) {
    // Along a side of a square or a triangle what is left has its form; and from anywhere.
    const double sides[] = {0, 90, 180, 270, 210.7, 329.3};
    const double side = sides[mark.random.below(6)] + mark.scene.faces[0].roll_deg;
    const double from = mark.random.below(2) == 0 ? side : mark.random.uniform(0, 360);
    const double speed = mark.random.uniform(20, 120) / rest.rate;
    return {from, speed, rest.level, mark.disparity() + (mark.random.below(2) == 0 ? 1 : 12)};
  }
  void slide(const Hand& hand, double from_px, double to_px, cv::Point2d over) {
    const double step = from_px < to_px ? hand.speed_px : -hand.speed_px;
    for (double edge = from_px; (to_px - edge) * step > 0; edge += step) {
      SCOPED_TRACE(testing::Message() << "its edge " << edge << " px from the centre");
      mark.put_hand(hand, edge, over);
      mark.look();
    }
  }
  void see_again() {
    mark.scene.blots.clear();
    mark.look();
    mark.look();
    EXPECT_TRUE(mark.seen_by_pair) << "by the pair";
    EXPECT_TRUE(mark.seen_by_one) << "by one camera";
    look_for(400ms);
  }
  void rest(const Rest& rest) {
    mark.rate = rest.rate;
    const Hand hand = hand_for(rest);
    const double edge = mark.random.uniform(-6, 8);
    const cv::Point2d over = mark.centre();
    SCOPED_TRACE(testing::Message() << "level " << rest.level << ", at " << rest.rate << " a second, from "
                                    << hand.from_deg << " degrees to " << edge << " px, " << hand.disparity_px
                                    << " px of disparity");
    slide(hand, CoveredMark::reach_px, edge, over);
    look_for(rest.duration);
    slide(hand, edge, CoveredMark::reach_px, over);
    see_again();
  }

  CoveredMark mark{std::get<0>(GetParam()), static_cast<std::uint64_t>(std::get<1>(GetParam()))};
};

TEST_P(Resting, HandNeverMakesAConfidentWrongPosition) {
  look_for(400ms);
  ASSERT_TRUE(mark.seen_by_pair && mark.seen_by_one);
  for (const Rest& each : {Rest{bright, 30s, 10}, Rest{dark, 30s, 10}, Rest{middle, 30s, 10}, Rest{bright, 30s, 60},
                           Rest{bright, 300s, 10}}) {
    rest(each);
  }
}

TEST_P(Resting, HandUnderWhichTheMarkWasMovedUncoversItWhereItIs) {
  look_for(400ms);
  ASSERT_TRUE(mark.seen_by_pair && mark.seen_by_one);
  for (const double far_mm : {3.0, 10.0, 20.0, 35.0}) {
    mark.rate = mark.random.below(2) == 0 ? 10 : 60;
    const Hand hand = hand_for({bright, 20s, mark.rate});
    slide(hand, CoveredMark::reach_px, -CoveredMark::reach_px, mark.centre());
    look_for(20s);
    SceneFace& face = mark.scene.faces[0];
    const double turn = mark.random.uniform(0, 2 * CV_PI);
    // A triangle a little farther away looks like one that is covered along a side.
    const bool triangle = face.mark == "triangle" || face.mark == "plate";
    face.place = {std::clamp(face.place.x + far_mm * std::cos(turn), -50.0, 50.0),
                  std::clamp(face.place.y + far_mm * std::sin(turn), -50.0, 50.0),
                  triangle ? face.place.z : mark.random.uniform(800, 950)};
    SCOPED_TRACE(testing::Message() << "moved by " << far_mm << " mm, at " << mark.rate << " a second");
    see_again();
  }
}

TEST_P(Resting, HandUnderWhichTheMarkWasTurnedAndPutElsewhereUncoversItThere) {
  look_for(400ms);
  ASSERT_TRUE(mark.seen_by_pair && mark.seen_by_one);
  for (const double yaw_deg : {-30.0, 30.0, 0.0}) {
    const Hand hand = hand_for({bright, 20s, mark.rate});
    slide(hand, CoveredMark::reach_px, -CoveredMark::reach_px, mark.centre());
    look_for(20s);
    SceneFace& face = mark.scene.faces[0];
    face.place.x += face.place.x > 0 ? -40 : 40;
    face.yaw_deg = yaw_deg;
    SCOPED_TRACE(testing::Message() << "turned to " << yaw_deg);
    see_again();
  }
}

// A nearer cover hides more of a mark from one camera than from the other, so that it looks larger than it is. The mark
// is not held to that size when the cover has gone.
TEST_P(Resting, HandThatCoversAPartFromTheFirstLookOnUncoversIt) {
  for (int i = 0; i < campaign(3, 6); ++i) {
    CoveredMark one{std::get<0>(GetParam()), mark.random.bits()};
    one.most_off_px = 10;
    const Hand hand{mark.random.uniform(0, 360), 0, bright, one.disparity() + mark.random.uniform(1, 12)};
    const double edge = mark.random.uniform(2, 9);
    SCOPED_TRACE(testing::Message() << "from " << hand.from_deg << " degrees to " << edge << " px, "
                                    << hand.disparity_px - one.disparity() << " px nearer");
    one.put_hand(hand, edge);
    for (int n = 0; n < 200; ++n) one.look();
    one.scene.blots.clear();
    for (int n = 0; n < 10; ++n) one.look();
    EXPECT_TRUE(one.seen_by_pair) << "by the pair";
  }
}

// Its centre is hardly off for that, however well its size was known. A disc without a segment is no disc.
using RestingStraight = Resting;

TEST_P(RestingStraight, CoverOverASliverLeavesTheMarkSeen) {
  mark.most_off_px = 0.75;
  mark.scene.noise = 1;
  const int ground = std::get<0>(GetParam()) == "end-effector" ? dark : bright;
  for (const double from_deg : {90.0, 270.0}) {
    mark.scene.blots.clear();
    look_for(30s);
    ASSERT_TRUE(mark.seen_by_pair);
    const double end_px = mark.end_px(from_deg);
    for (const double deep_px : {0.25, 0.5, 0.75}) {
      SCOPED_TRACE(testing::Message() << deep_px << " px deep from " << from_deg << " degrees");
      mark.put_hand({from_deg, 0, ground, mark.disparity() + 2}, end_px - deep_px);
      for (int n = 0; n < 30; ++n) {
        mark.look();
        ASSERT_TRUE(mark.seen_by_pair) << "frame " << n;
      }
    }
  }
}

// A nearer cover hides a part of the mark from the right camera alone, and then leaves.
TEST_P(Resting, CoverBeforeOneCameraUncoversIt) {
  for (const double deep_px : {1.0, 1.5, 2.0, 2.5, 3.0}) {
    CoveredMark one{std::get<0>(GetParam()), mark.random.bits()};
    one.most_off_px = 10;
    constexpr double nearer_px = 12;
    SCOPED_TRACE(testing::Message() << deep_px << " px deep");
    one.put_hand({0, 0, bright, one.disparity() + nearer_px}, one.end_px(0) + nearer_px - deep_px);
    for (int n = 0; n < 30; ++n) one.look();
    one.scene.blots.clear();
    for (int n = 0; n < 10; ++n) one.look();
    EXPECT_TRUE(one.seen_by_pair);
  }
}

std::string resting_name(const testing::TestParamInfo<Resting::ParamType>& one) {
  std::string name = std::get<0>(one.param);
  std::erase(name, '-');
  return name + std::to_string(std::get<1>(one.param));
}

INSTANTIATE_TEST_SUITE_P(Seeds, Resting,
                         testing::Combine(testing::Values("circle", "square", "cross", "triangle", "end-effector"),
                                          testing::Range(1, campaign(2, 3))),
                         resting_name);

INSTANTIATE_TEST_SUITE_P(Seeds, RestingStraight,
                         testing::Combine(testing::Values("square", "cross", "triangle", "end-effector"),
                                          testing::Range(1, campaign(3, 6))),
                         resting_name);

}  // namespace
}  // namespace pizarra::vision
