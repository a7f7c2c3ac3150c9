// Marks of every shape go slowly behind something that stands still, from anywhere, before a pair of cameras and before
// one alone: what is told for sure meanwhile is where the mark is. And marks that turn, come and go in full view go on
// being told; those that face the camera, for sure.

#include <gtest/gtest.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/agents/vision/eyes.hpp"
#include "tests/campaign.hpp"

namespace pizarra::vision {
namespace {

constexpr double off_px = 1;
constexpr double most_off_px = 2;
constexpr double surely = 0.9;
constexpr double mark_mm = 44;
constexpr double cover_px = 90;

camera::StereoModel camera() {
  camera::StereoModel out;
  out.width = 240;
  out.height = 144;
  out.centre_x_px = 119.5;
  out.centre_y_px = 71.5;
  return out;
}

enum class Eyes : std::uint8_t { pair, one };

class Passing : public testing::TestWithParam<std::tuple<std::string, Eyes>> {
 protected:
  struct Told {
    int positions = 0;
    int sure = 0;
    int wrong = 0;  // of those, more than off_px off
    double most_off_px = 0;
    int lost = 0;
  };

  std::string name() const { return std::get<0>(GetParam()); }
  bool is_single() const { return std::get<1>(GetParam()) == Eyes::one; }
  camera::StereoModel eyes() const {
    camera::StereoModel out = model;
    if (is_single()) out.base_line_mm = 0;
    if (is_single()) out.learned_at_mm = 850;
    return out;
  }

  void begin(int seed) {
    random = Random(static_cast<std::uint64_t>(seed)).split("passing " + name());
    size_px = random.uniform(20, 36);
    scene = {};
    scene.noise = random.uniform(1, 6);
    scene.blur_px = random.uniform(0.5, 1);
    scene.faces = {{.mark = drawn_as(name()),
                    .place = {},
                    .yaw_deg = random.uniform(-25, 25),
                    .roll_deg = random.uniform(-12, 12)}};
    tracker.clear();
    EXPECT_TRUE(tracker.add(*learned_cell().find(name())));
  }
  bool is_triangle() const { return name() == "triangle" || name() == "end-effector"; }
  // So large it looked at 850 mm.
  double learned_px() const { return mark_mm * model.focal_px / 850; }
  double depth_mm() const { return mark_mm * model.focal_px / size_px; }
  double disparity_px() const { return model.focal_px * model.base_line_mm / depth_mm(); }
  // In the middle of what both images show, in the left one.
  cv::Point2d middle() const { return {model.centre_x_px + disparity_px() / 2, model.centre_y_px}; }

  void look(cv::Point2d centre, double depth_mm) {
    SceneFace& face = scene.faces.front();
    face.place = {(centre.x - model.centre_x_px) * depth_mm / model.focal_px - model.base_line_mm / 2,
                  (centre.y - model.centre_y_px) * depth_mm / model.focal_px, depth_mm};
    const camera::StereoFrame frame = draw_scene(scene, model, 1, random);
    const cv::Mat nothing = cv::Mat::zeros(frame.left->height, frame.left->width, CV_8UC1);
    const camera::StereoModel seen_by = eyes();
    StereoSight sight(as_mat(*frame.left), is_single() ? nothing : as_mat(*frame.right), seen_by);
    now += 100ms;
    const TrackSighting sighting = tracker.update(sight, now).front();
    if (!sighting.seen) {
      ++told.lost;
      return;
    }
    const double off = cv::norm(sighting.centre - centre);
    ++told.positions;
    if (sighting.confidence < surely) return;
    ++told.sure;
    told.wrong += off > off_px ? 1 : 0;
    told.most_off_px = std::max(told.most_off_px, off);
  }
  // Three frames at rest, then on until more than half of it is hidden.
  void pass_behind_something() {
    const double speeds[] = {0.5, 0.7, 1, 1.4, 2, 3};
    const double speed = speeds[random.below(6)];
    const double way = random.uniform(0, 2 * CV_PI);
    const double against = way + random.uniform(-40, 40) * CV_PI / 180;
    const cv::Point2d edge = middle() + cv::Point2d(random.uniform(-5, 5), random.uniform(-5, 5));
    const cv::Point2d cover = edge + cover_px / 2 * cv::Point2d(std::cos(against), std::sin(against));
    const int levels[] = {25, 95, 150, 190, 225};
    const double nearer_px = random.below(2) == 0 ? 1 : random.uniform(0.02, 0.3) * disparity_px();
    scene.blots = {{.box = {cover.x - cover_px / 2, cover.y - cover_px / 2, cover_px, cover_px},
                    .level = levels[random.below(5)],
                    .disparity_px = disparity_px() + nearer_px,
                    .turn_deg = against * 180 / CV_PI}};
    double along = -0.72 * size_px - 6 * speed;
    for (int frame = 0; along < 0.3 * size_px; ++frame) {
      look(edge + along * cv::Point2d(std::cos(way), std::sin(way)), depth_mm());
      if (frame >= 2) along += speed;
    }
  }
  // Round in a circle, now faster and now slower, while it turns, comes nearer and goes away.
  void move_freely(double turn_deg, double most_nearer) {
    const double speed = random.uniform(0.5, 3);
    const double turn_rate = random.uniform(0.05, 0.3);
    const double nearer = random.uniform(0, most_nearer);
    double path = 0;
    for (int frame = 0; frame < 40; ++frame) {
      path += speed * (1 + 0.9 * std::sin(0.2 * frame));
      scene.faces.front().yaw_deg = turn_deg * std::sin(turn_rate * frame);
      look(middle() + 25 * cv::Point2d(std::cos(path / 25), std::sin(path / 25)),
           depth_mm() * (1 + nearer * std::sin(0.13 * frame)));
    }
  }

  const camera::StereoModel model = camera();
  Random random{1};
  Scene scene;
  double size_px = 0;
  MarkTracker tracker{learned_cell()};
  Time now = {};
  Told told;
};

TEST_P(Passing, BehindSomethingIsToldWhereItIsOrNotAtAll) {
  const int passes = campaign(8, 20);
  for (int seed = 1; seed <= passes; ++seed) {
    begin(seed);
    pass_behind_something();
  }
  EXPECT_LT(told.most_off_px, most_off_px);
  // One in three hundred may be a little off, as the noise falls.
  EXPECT_LE(told.wrong, told.positions / 300) << "of " << told.positions;
  EXPECT_GT(told.positions, 8 * passes);
}

TEST_P(Passing, TurningAndMovingInFullViewGoesOnBeingTold) {
  const int paths = campaign(3, 8);
  for (int seed = 1; seed <= paths; ++seed) {
    begin(seed);
    move_freely(random.uniform(5, 25), 0.1);
  }
  EXPECT_LT(told.most_off_px, off_px);
  EXPECT_LE(told.lost, told.positions / 50) << "of " << told.positions;
}

// Of a triangle only one that one camera sees no smaller than it was learned, and than it has been since: what is left
// of one that is covered along a side is a smaller triangle.
TEST_P(Passing, MovingAndFacingTheCameraGoesOnBeingSure) {
  const int paths = campaign(3, 8);
  for (int seed = 1; seed <= paths; ++seed) {
    begin(seed);
    if (is_triangle()) size_px = std::max(size_px, learned_px());
    move_freely(0, is_triangle() ? 0 : 0.1);
  }
  EXPECT_LT(told.most_off_px, off_px);
  EXPECT_GE(told.sure, 0.98 * 40 * paths);
}

class PassingTriangle : public Passing {
 protected:
  // How many frames of five are sure once it has come or gone to where it is so large.
  int sure_at(double then_px, int frames) {
    told = {};
    const double before_px = size_px;
    for (int frame = 1; frame <= frames; ++frame) {
      size_px = before_px + (then_px - before_px) * frame / frames;
      look(middle(), depth_mm());
    }
    EXPECT_LE(told.lost, frames / 20);
    EXPECT_LT(told.most_off_px, off_px);
    told = {};
    for (int frame = 0; frame < 5; ++frame) look(middle(), depth_mm());
    return told.sure;
  }
};

// A pair knows how far away it is. One camera is not sure of it where it has gone away since, until it is back.
TEST_P(PassingTriangle, IsSureByOneCameraUnlessItHasLookedLargerSinceTrackingBegan) {
  for (int seed = 1; seed <= campaign(3, 8); ++seed) {
    SCOPED_TRACE(seed);
    begin(seed);
    scene.faces.front().yaw_deg = 0;
    const bool always = !is_single();
    size_px = 1.2 * learned_px();
    EXPECT_EQ(sure_at(size_px, 5), 5) << "nearer than it was learned";
    EXPECT_EQ(sure_at(1.05 * learned_px(), 20), always ? 5 : 0) << "farther than it was";
    EXPECT_EQ(sure_at(1.2 * learned_px(), 20), 5) << "back";
  }
}

// A cover's edge does not turn with the mark.
TEST_P(PassingTriangle, IsSureByOneCameraThoughItHasLookedLargerOnceAllItsSidesHaveTurned) {
  for (int seed = 1; seed <= campaign(3, 8); ++seed) {
    SCOPED_TRACE(seed);
    begin(seed);
    scene.faces.front().yaw_deg = 0;
    size_px = 1.2 * learned_px();
    EXPECT_EQ(sure_at(size_px, 5), 5) << "near";
    sure_at(1.05 * learned_px(), 20);
    for (int frame = 0; frame < 16; ++frame) {
      scene.faces.front().roll_deg += 1;
      look(middle(), depth_mm());
    }
    EXPECT_EQ(sure_at(size_px, 1), 5) << "farther and turned";
  }
}

std::string passing_name(const testing::TestParamInfo<Passing::ParamType>& one) {
  std::string name = std::get<0>(one.param);
  std::erase(name, '-');
  return name + (std::get<1>(one.param) == Eyes::pair ? "ByAPair" : "ByOneCamera");
}

INSTANTIATE_TEST_SUITE_P(Marks, Passing,
                         testing::Combine(testing::ValuesIn(cell_marks()), testing::Values(Eyes::pair, Eyes::one)),
                         passing_name);
INSTANTIATE_TEST_SUITE_P(Marks, PassingTriangle,
                         testing::Combine(testing::Values("triangle", "end-effector"),
                                          testing::Values(Eyes::pair, Eyes::one)),
                         passing_name);

}  // namespace
}  // namespace pizarra::vision
