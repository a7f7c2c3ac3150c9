// A hand that slides over a mark that is tracked, from any side, slowly or fast, and away again: how much of what is
// told meanwhile to be seen is more than 2 px off.

#include <cmath>
#include <fmt/format.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr double wrong_px = 2;
constexpr int frames_before = 5;
constexpr double hand_mm = 150;
constexpr double reach_mm = 30;  // from where the hand touches no mark to where it hides all of it

constexpr SceneRanges lab_ranges = {.least_light = 0.7,
                                    .most_light = 1.3,
                                    .least_scale = 0.8,
                                    .most_scale = 1.2,
                                    .most_turn_deg = 30,
                                    .most_noise = 8,
                                    .most_blur_px = 1};

struct Sliding {
  SceneMark mark;
  double direction;  // radians, where the hand comes from
  double speed_mm;   // a frame
  double level;
  double depth_mm;

  SceneThing at(double edge_mm) const {
    const double scale = scale_at(mark.depth_mm);
    const cv::Point2d from(std::cos(direction), std::sin(direction));
    return {.shape = placed(box(hand_mm, hand_mm), mark.centre + (edge_mm + hand_mm / 2) * scale * from, scale,
                            direction * 180 / CV_PI),
            .level = level,
            .depth_mm = depth_mm,
            .in_front = true};
  }
};

struct Told {
  int seen = 0;
  int wrong = 0;

  void count(const std::vector<TrackSighting>& sightings, cv::Point2d truth) {
    if (!sightings.front().seen) return;
    ++seen;
    wrong += cv::norm(sightings.front().centre - truth) > wrong_px ? 1 : 0;
  }
  double percent() const { return 100.0 * wrong / std::max(1, seen); }
};

const StereoModel& one_camera() {
  static const StereoModel model = [] {
    StereoModel out = scene_camera();
    out.base_line_mm = 0;
    out.learned_at_mm = learning_depth_mm;
    return out;
  }();
  return model;
}

void slide(const VisionBench& bench, Random& random, Told& by_one, Told& by_pair) {
  Scene scene = random_scene(lab_ranges, random);
  scene.marks = {scene.marks[random.below(scene.marks.size())]};
  scene.things.clear();
  const double levels[] = {60, 110, scene.ground_level};
  const SceneMark& mark = scene.marks.front();
  const Sliding hand{mark, random.uniform(0, 2 * CV_PI),
                     random.below(2) == 0 ? random.uniform(1, 4) : random.uniform(8, 25), levels[random.below(3)],
                     mark.depth_mm * (random.below(2) == 0 ? 0.98 : 0.8)};
  MarkTracker one(bench.marks);
  MarkTracker pair(bench.marks);
  for (MarkTracker* tracker : {&one, &pair}) {
    if (!tracker->add(*bench.marks.find(mark.name))) throw std::runtime_error("too many objects");
  }
  Time time = {};
  const auto look = [&](const Scene& now) {
    const cv::Mat1b left = draw(now, Side::left, random);
    StereoSight alone(left, cv::Mat1b::zeros(left.size()), one_camera());
    StereoSight both(left, draw(now, Side::right, random), scene_camera());
    time += 100ms;
    by_one.count(one.update(alone, time), mark.centre);
    by_pair.count(pair.update(both, time), mark.centre);
  };
  for (int frame = 0; frame < frames_before; ++frame) look(scene);
  const int steps = static_cast<int>(2 * reach_mm / hand.speed_mm);
  for (int step = -steps; step <= steps; ++step) {
    Scene now = scene;
    now.things.push_back(hand.at(reach_mm - hand.speed_mm * (steps - std::abs(step))));
    look(now);
  }
}

}  // namespace

void coverings(VisionBench& bench) {
  Told by_one;
  Told by_pair;
  const int runs = std::max(1, bench.runs / 4);
  for (int i = 0; i < runs; ++i) {
    Random random = Random(bench.seed).split(fmt::format("covering {}", i));
    slide(bench, random, by_one, by_pair);
  }
  for (const auto& [who, told] : {std::pair("a pair", by_pair), std::pair("one camera", by_one)}) {
    bench.figures.say({fmt::format("told 2 px off while a hand slides over, {}", who),
                       told.percent(),
                       "%",
                       at_most(0.1),
                       {},
                       fmt::format("{} of {} positions, {} hands", told.wrong, told.seen, runs)});
  }
}

}  // namespace pizarra::bench
