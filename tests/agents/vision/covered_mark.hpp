#pragma once

// A mark, a hand that slides over it, and two trackers that look on: one before a pair, one before its left camera
// alone. A mark that either tells as seen must be where it is told.
//
//   CoveredMark mark("square", seed);
//   mark.put_hand(hand, 5);                     // its edge 5 px from the mark's centre
//   mark.look();                                // a frame later
//   mark.scene.blots.clear();                   // it has left

#include <algorithm>
#include <gtest/gtest.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"

namespace pizarra::vision {

struct Hand {
  double from_deg;  // where it comes from
  double speed_px;  // a frame
  int level;
  double disparity_px;
};

class CoveredMark {
 public:
  static constexpr double reach_px = 18;  // from its centre

  CoveredMark(const std::string& name, std::uint64_t seed) : random(Random(seed).split(name)) {
    scene.noise = random.uniform(1, 6);
    scene.blur_px = random.uniform(0.5, 1);
    scene.faces = {{.mark = drawn_as(name),
                    .place = {random.uniform(-30, 40), random.uniform(-40, 40), random.uniform(800, 950)},
                    .yaw_deg = random.uniform(-20, 20),
                    .roll_deg = random.uniform(-10, 10)}};
    for (MarkTracker* each : {&pair, &single}) EXPECT_TRUE(each->add(*learned_cell().find(name)));
  }

  cv::Point2d centre() const { return project(model, scene.faces[0].place, false); }
  double disparity() const { return model.focal_px * model.base_line_mm / scene.faces[0].place.z; }
  // From its centre to its end at 0 (right), 90 (below), 180 or 270 degrees, as the left image shows it without noise.
  double end_px(double at_deg) const {
    Random none(1);
    Scene clear = scene;
    clear.noise = 0;
    clear.blots.clear();
    const camera::StereoFrame frame = draw_scene(clear, model, 1, none);
    StereoSight sight(as_mat(*frame.left), as_mat(*frame.right), model);
    const std::vector<SeenMark>& marks = sight.left_segmentation().marks();
    const auto away = [&](const SeenMark& seen) { return cv::norm(seen.centre - centre()); };
    const cv::Rect box = std::ranges::min_element(marks, {}, away)->box;
    const cv::Point2d low(box.x - 0.5, box.y - 0.5), high(box.br().x - 0.5, box.br().y - 0.5);
    if (at_deg == 0) return high.x - centre().x;
    if (at_deg == 90) return high.y - centre().y;
    return at_deg == 180 ? centre().x - low.x : centre().y - low.y;
  }
  // Its edge is so far from where the mark's centre was when `at` was asked for.
  void put_hand(const Hand& hand, double edge_px) { put_hand(hand, edge_px, centre()); }
  void put_hand(const Hand& hand, double edge_px, cv::Point2d at) {
    constexpr double wide = 90;
    const double from = hand.from_deg * CV_PI / 180;
    const cv::Point2d middle = at + (edge_px + wide / 2) * cv::Point2d(std::cos(from), std::sin(from));
    scene.blots = {{.box = {middle.x - wide / 2, middle.y - wide / 2, wide, wide},
                    .level = hand.level,
                    .disparity_px = hand.disparity_px,
                    .turn_deg = hand.from_deg}};
  }

  camera::StereoFrame draw() { return draw_scene(scene, model, 1, random); }
  void look() { look(draw()); }
  void look(const camera::StereoFrame& frame) {
    const cv::Mat nothing = cv::Mat::zeros(frame.left->height, frame.left->width, CV_8UC1);
    StereoSight both(as_mat(*frame.left), as_mat(*frame.right), model);
    StereoSight left_only(as_mat(*frame.left), nothing, alone);
    now += 1'000'000us / rate;
    seen_by_pair = is_seen(pair.update(both, now)[0]);
    seen_by_one = is_seen(single.update(left_only, now)[0]);
  }

  Random random;
  const camera::StereoModel model = two_cameras(160, 120);
  const camera::StereoModel alone = one_camera_of(model);
  Scene scene;
  double most_off_px = 1.5;
  int rate = 10;  // frames a second
  bool seen_by_pair = false;
  bool seen_by_one = false;

 private:
  bool is_seen(const TrackSighting& sighting) const {
    if (!sighting.seen) return false;
    EXPECT_LT(cv::norm(sighting.centre - centre()), most_off_px);
    return true;
  }

  Time now = {};
  MarkTracker pair{learned_cell()};
  MarkTracker single{learned_cell()};
};

}  // namespace pizarra::vision
