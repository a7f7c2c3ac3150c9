#pragma once

// A mark and something that comes to lie in front of a part of it: the mark goes behind what rests, a hand slides over
// the mark, or both move, at 10 to 120 frames a second; or a part is hidden from the first frame. Two trackers look on,
// one before a pair of cameras and one before the left camera alone. The positions that they tell surely are counted,
// and how far off they are.
//
//   Meeting meeting("square", seed, Meeting::Way::both);
//   meeting.run();
//   meeting.by_pair.wrong;                      // positions told as sure, and more than a pixel off

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"

namespace pizarra::vision {

struct ToldOfMeeting {
  static constexpr double surely = 0.9;
  static constexpr double off_px = 1;

  int positions = 0;
  int sure = 0;
  int wrong = 0;  // of those that are sure, more than off_px off
  double most_off_px = 0;
  double most_told_off_px = 0;  // of all

  void count(const TrackSighting& sighting, cv::Point2d truth) {
    if (!sighting.seen) return;
    ++positions;
    const double off = cv::norm(sighting.centre - truth);
    most_told_off_px = std::max(most_told_off_px, off);
    if (sighting.confidence < surely) return;
    ++sure;
    wrong += off > off_px ? 1 : 0;
    most_off_px = std::max(most_off_px, off);
  }
  ToldOfMeeting& operator+=(const ToldOfMeeting& other) {
    positions += other.positions;
    sure += other.sure;
    wrong += other.wrong;
    most_off_px = std::max(most_off_px, other.most_off_px);
    most_told_off_px = std::max(most_told_off_px, other.most_told_off_px);
    return *this;
  }
};

class Meeting {
 public:
  enum class Way : std::uint8_t { mark_slowly, mark_quickly, hand, both, hidden_from_the_first };

  Meeting(const std::string& name, std::uint64_t seed, Way chosen)
      : random(Random(seed).split("meeting " + name)), way(chosen) {
    size_px = random.uniform(18, 40);
    scene.noise = random.uniform(1, 6);
    scene.blur_px = random.uniform(0.5, 1);
    // Straight before the camera, and covered along a side, half a square is as good a square turned.
    straight = random.below(2) == 0;
    scene.faces = {{.mark = drawn_as(name),
                    .place = {},
                    .yaw_deg = straight ? 0 : random.uniform(-25, 25),
                    .roll_deg = straight ? 0 : random.uniform(-12, 12)}};
    const double rates[] = {10, 30, 60, 120};
    rate = rates[random.below(4)];
    for (MarkTracker* each : {&pair, &single}) each->add(*learned_cell().find(name)).value();
    put_cover();
  }

  // From some frames at rest until more than half of the mark is hidden.
  void run() {
    const bool begins_hidden = way == Way::hidden_from_the_first;
    const double first = (begins_hidden ? random.uniform(-0.5, 0.1) : -0.8) * size_px;
    const double step = begins_hidden ? 0 : px_a_frame();
    // The mark's and the hand's shares of the way that brings them together, along the cover's normal.
    const double by_mark = way == Way::hand ? 0 : way == Way::both ? random.uniform(-1, 1.5) : 1;
    const int rest = static_cast<int>(random.uniform(2, 20));
    const double aside = way == Way::hand ? 0 : std::tan(random.uniform(-40, 40) * CV_PI / 180);
    double gone = 0;
    for (int frame = 0; frame < 400 && first + gone < 0.3 * size_px && !(begins_hidden && frame > 5); ++frame) {
      const double of_mark = by_mark * (gone - 0.5 * size_px);
      look(middle() + of_mark * normal + aside * of_mark * cv::Point2d(-normal.y, normal.x), first + gone);
      if (frame >= rest) gone += step;
    }
  }

  ToldOfMeeting by_pair;
  ToldOfMeeting by_one;

 private:
  static constexpr double mark_mm = 44;
  static constexpr double cover_px = 90;

  double depth_mm() const { return mark_mm * model.focal_px / size_px; }
  double disparity_px() const { return model.focal_px * model.base_line_mm / depth_mm(); }
  // The middle, in the left image, of the area that both images show.
  cv::Point2d middle() const { return {model.centre_x_px + disparity_px() / 2, model.centre_y_px}; }
  double px_a_frame() {
    if (way == Way::mark_quickly) return random.uniform(2, 12);
    const double px_a_second = std::exp(random.uniform(std::log(5), std::log(60)));
    return std::clamp(px_a_second / rate, 0.1, 4.0);
  }
  void put_cover() {
    const double from = straight ? CV_PI / 2 * static_cast<double>(random.below(4)) : random.uniform(0, 2 * CV_PI);
    normal = {std::cos(from), std::sin(from)};
    const int levels[] = {25, 95, 150, 190, 225};
    nearer_px = random.below(2) == 0 ? 1 : random.uniform(0.02, 0.3) * disparity_px();
    scene.blots = {{.box = {0, 0, cover_px, cover_px},
                    .level = levels[random.below(5)],
                    .disparity_px = disparity_px() + nearer_px,
                    .turn_deg = from * 180 / CV_PI}};
  }
  // `depth`: how far the mark's centre is behind the cover's edge.
  void look(cv::Point2d centre, double depth) {
    scene.faces.front().place = {(centre.x - model.centre_x_px) * depth_mm() / model.focal_px - model.base_line_mm / 2,
                                 (centre.y - model.centre_y_px) * depth_mm() / model.focal_px, depth_mm()};
    const cv::Point2d cover = centre + (cover_px / 2 - depth) * normal;
    scene.blots.front().box.x = cover.x - cover_px / 2;
    scene.blots.front().box.y = cover.y - cover_px / 2;
    const camera::StereoFrame frame = draw_scene(scene, model, 1, random);
    const cv::Mat nothing = cv::Mat::zeros(frame.left->height, frame.left->width, CV_8UC1);
    StereoSight both(as_mat(*frame.left), as_mat(*frame.right), model);
    StereoSight left_only(as_mat(*frame.left), nothing, alone);
    now += std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / rate));
    by_pair.count(pair.update(both, now).front(), centre);
    by_one.count(single.update(left_only, now).front(), centre);
  }

  Random random;
  const Way way;
  const camera::StereoModel model = two_cameras(200, 144);
  const camera::StereoModel alone = one_camera_of(model);
  Scene scene;
  double size_px = 0;
  double rate = 0;
  bool straight = false;
  double nearer_px = 0;
  cv::Point2d normal;
  MarkTracker pair{learned_cell()};
  MarkTracker single{learned_cell()};
  Time now = {};
};

}  // namespace pizarra::vision
