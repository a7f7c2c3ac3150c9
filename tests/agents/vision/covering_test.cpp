// A hand, light or dark, slides over a mark and away again: slowly and fast, from anywhere, before one camera and
// before a pair. What is told to be seen is where the mark is.

#include <gtest/gtest.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"

namespace pizarra {
namespace {

constexpr double most_off_px = 1.5;
constexpr double reach_px = 18;  // of a mark, from its centre

struct Hand {
  double from_deg;  // where it comes from
  double speed_px;  // a frame
  int level;
  double disparity_px;
};

// A part of the cell's images.
StereoModel two_cameras() {
  StereoModel out;
  out.width = 160;
  out.height = 120;
  out.centre_x_px = 79.5;
  out.centre_y_px = 59.5;
  return out;
}

StereoModel one_camera() {
  StereoModel out = two_cameras();
  out.base_line_mm = 0;
  out.learned_at_mm = 850;
  return out;
}

class Covering : public testing::TestWithParam<std::tuple<std::string, int>> {
 protected:
  Covering() {
    scene.noise = random.uniform(1, 6);
    scene.blur_px = random.uniform(0.5, 1);
    scene.faces = {{.mark = drawn_as(name),
                    .place = {random.uniform(-30, 40), random.uniform(-40, 40), random.uniform(800, 950)},
                    .yaw_deg = random.uniform(-20, 20),
                    .roll_deg = random.uniform(-10, 10)}};
    centre = project(model, scene.faces[0].place, false);
    for (MarkTracker* each : {&pair, &single}) EXPECT_TRUE(each->add(*learned_cell().find(name)));
  }

  // Its edge is so far from the mark's centre.
  void put_hand(const Hand& hand, double edge_px) {
    constexpr double wide = 90;
    const double from = hand.from_deg * CV_PI / 180;
    const cv::Point2d middle = centre + (edge_px + wide / 2) * cv::Point2d(std::cos(from), std::sin(from));
    scene.blots = {{.box = {middle.x - wide / 2, middle.y - wide / 2, wide, wide},
                    .level = hand.level,
                    .disparity_px = hand.disparity_px,
                    .turn_deg = hand.from_deg}};
  }
  void look() {
    const StereoFrame frame = draw_scene(scene, model, 1, random);
    const cv::Mat nothing = cv::Mat::zeros(frame.left->height, frame.left->width, CV_8UC1);
    StereoSight both(as_mat(*frame.left), as_mat(*frame.right), model);
    StereoSight left_only(as_mat(*frame.left), nothing, alone);
    seen_by_pair = is_seen(pair.update(both)[0]);
    seen_by_one = is_seen(single.update(left_only)[0]);
  }
  bool is_seen(const TrackSighting& sighting) {
    if (!sighting.seen) return false;
    const double off = cv::norm(sighting.centre - centre);
    EXPECT_LT(off, most_off_px);
    return true;
  }
  void slide(const Hand& hand) {
    for (double edge = reach_px; edge > -reach_px; edge -= hand.speed_px) {
      SCOPED_TRACE(testing::Message() << "its edge " << edge << " px from the centre");
      put_hand(hand, edge);
      look();
    }
    put_hand(hand, -reach_px);
    look();
    EXPECT_FALSE(seen_by_pair || seen_by_one);
    for (double edge = -reach_px; edge < reach_px; edge += hand.speed_px) {
      SCOPED_TRACE(testing::Message() << "leaving, its edge " << edge << " px from the centre");
      put_hand(hand, edge);
      look();
    }
    scene.blots.clear();
    look();
    look();
    EXPECT_TRUE(seen_by_pair && seen_by_one);
  }

  const std::string name = std::get<0>(GetParam());
  Random random = Random(static_cast<std::uint64_t>(std::get<1>(GetParam()))).split(name);
  const StereoModel model = two_cameras();
  const StereoModel alone = one_camera();
  Scene scene;
  cv::Point2d centre;
  MarkTracker pair{learned_cell()};
  MarkTracker single{learned_cell()};
  bool seen_by_pair = false;
  bool seen_by_one = false;
};

TEST_P(Covering, NeverMakesAConfidentWrongPosition) {
  for (int n = 0; n < 4; ++n) look();
  ASSERT_TRUE(seen_by_pair && seen_by_one);
  for (int n = 0; n < 4; ++n) {
    const int levels[] = {25, 60, 95, 150, 190, 225};
    Hand hand{random.uniform(0, 360), random.below(2) == 0 ? random.uniform(1, 2) : random.uniform(5, 15),
              levels[random.below(6)], 0};
    const double disparity = model.focal_px * model.base_line_mm / scene.faces[0].place.z;
    hand.disparity_px = disparity + (random.below(2) == 0 ? 1 : 12);
    SCOPED_TRACE(testing::Message() << "from " << hand.from_deg << " degrees at " << hand.speed_px
                                    << " px a frame, level " << hand.level << ", disparity "
                                    << hand.disparity_px - disparity << " more, yaw " << scene.faces[0].yaw_deg);
    slide(hand);
  }
}

class CoveringATriangle : public Covering {};

// What is left of it has its form, and is smaller.
TEST_P(CoveringATriangle, AlongASideLeavesNoTriangle) {
  scene.faces[0].yaw_deg = 0;
  for (int n = 0; n < 4; ++n) look();
  ASSERT_TRUE(seen_by_pair && seen_by_one);
  const double disparity = model.focal_px * model.base_line_mm / scene.faces[0].place.z;
  for (const double side_deg : {90.0, 210.7, 329.3}) {
    SCOPED_TRACE(testing::Message() << "from " << side_deg << " degrees");
    slide({side_deg + scene.faces[0].roll_deg, random.uniform(1.5, 2.5), 190, disparity + 12});
  }
}

std::string instance_name(const testing::TestParamInfo<Covering::ParamType>& one) {
  std::string name = std::get<0>(one.param);
  std::erase(name, '-');
  return name + std::to_string(std::get<1>(one.param));
}

INSTANTIATE_TEST_SUITE_P(Seeds, Covering,
                         testing::Combine(testing::Values("circle", "square", "cross", "triangle", "end-effector"),
                                          testing::Range(1, 3)),
                         instance_name);
INSTANTIATE_TEST_SUITE_P(Seeds, CoveringATriangle,
                         testing::Combine(testing::Values("triangle", "end-effector"), testing::Range(1, 3)),
                         instance_name);

}  // namespace
}  // namespace pizarra
