// Tracking through what loses an object: half a second behind something, and 300 px/s at ten frames a second.

#include <cmath>
#include <fmt/format.h>

#include "agents/vision/sight/mark_tracker.hpp"
#include "tests/bench/vision/rows.hpp"

namespace pizarra::bench {
namespace {

constexpr int frames = 16;
constexpr int hidden_from = 5;
constexpr int hidden_frames = 5;
constexpr int frames_to_recover = 2;
constexpr double same_place_px = 3;
constexpr double fast_px = 30;  // a frame

constexpr SceneRanges lab_ranges = {.least_light = 0.7,
                                    .most_light = 1.3,
                                    .least_scale = 0.8,
                                    .most_scale = 1.2,
                                    .most_turn_deg = 30,
                                    .most_noise = 8,
                                    .most_blur_px = 1,
                                    .most_clutter = 4};

// A path of so many px a frame that turns back at the borders, both coordinates by themselves.
double there_and_back(double start, double travelled, double low, double high) {
  const double span = high - low;
  const double along = std::fmod(std::abs(start - low + travelled), 2 * span);
  return low + (along < span ? along : 2 * span - along);
}

struct Sequence {
  Scene scene;
  std::size_t hero;  // the mark to which it happens
  cv::Point2d start;
  double direction;
  bool fast;

  bool hidden(int frame) const { return !fast && frame >= hidden_from && frame < hidden_from + hidden_frames; }

  Scene at(int frame) const {
    Scene out = scene;
    SceneMark& mark = out.marks[hero];
    if (fast) {
      const double travelled = fast_px * frame;
      mark.centre.x = there_and_back(start.x, travelled * std::cos(direction), 95, 285);
      mark.centre.y = there_and_back(start.y, travelled * std::sin(direction), 35, 205);
    }
    if (hidden(frame)) {
      const double side = 66 * scale_at(mark.depth_mm);
      out.things.push_back({.shape = placed(box(side, side), mark.centre, 1, 20),
                            .level = 90,
                            .depth_mm = mark.depth_mm * 0.98,
                            .in_front = true});
    }
    return out;
  }
};

Sequence random_sequence(Random& random, bool fast) {
  Sequence out{.scene = random_scene(lab_ranges, random), .hero = 0, .start = {}, .direction = 0, .fast = fast};
  out.hero = random.below(out.scene.marks.size());
  out.start = out.scene.marks[out.hero].centre;
  out.direction = random.uniform(0, 2 * CV_PI);
  if (fast) {
    // It has the scene to itself.
    out.scene.marks = {out.scene.marks[out.hero]};
    out.scene.things.clear();
    out.hero = 0;
  }
  return out;
}

struct Verdict {
  bool recovered = true;
  bool wrong = false;
};

Verdict follow(const VisionBench& bench, const Sequence& sequence, Random& random) {
  vision::MarkTracker tracker(bench.marks);
  for (const SceneMark& mark : sequence.scene.marks) {
    if (!tracker.add(*bench.marks.find(mark.name))) throw std::runtime_error("too many objects");
  }
  Verdict verdict;
  int visible_for = 0;
  for (int frame = 0; frame < frames; ++frame) {
    const Scene scene = sequence.at(frame);
    vision::StereoSight sight(draw(scene, Side::left, random), draw(scene, Side::right, random), scene_camera());
    visible_for = sequence.hidden(frame) ? 0 : visible_for + 1;
    for (const vision::TrackSighting& sighting : tracker.update(sight, Time(frame * 100ms))) {
      const auto truth = std::ranges::find(scene.marks, sighting.name, &SceneMark::name);
      const bool is_hero = truth - scene.marks.begin() == static_cast<std::ptrdiff_t>(sequence.hero);
      if (sighting.seen && cv::norm(sighting.centre - truth->centre) > same_place_px) verdict.wrong = true;
      if (is_hero && sighting.seen && sequence.hidden(frame)) verdict.wrong = true;
      if (is_hero && !sighting.seen && visible_for >= frames_to_recover) verdict.recovered = false;
    }
  }
  return verdict;
}

void say_runs(VisionBench& bench, const std::string& name, bool fast) {
  int good = 0;
  int wrong = 0;
  for (int i = 0; i < bench.runs; ++i) {
    Random random = Random(bench.seed).split(fmt::format("{} {}", name, i));
    const Verdict verdict = follow(bench, random_sequence(random, fast), random);
    good += verdict.recovered && !verdict.wrong ? 1 : 0;
    wrong += verdict.wrong ? 1 : 0;
  }
  bench.figures.say({name,
                     100.0 * good / bench.runs,
                     "%",
                     at_least(99),
                     {},
                     fmt::format("{} runs, {} with a wrong position", bench.runs, wrong)});
}

}  // namespace

void sequences(VisionBench& bench) {
  say_runs(bench, "seen again within 2 frames after 0.5 s hidden", false);
  say_runs(bench, "followed at 300 px/s, 10 frames/s", true);
}

}  // namespace pizarra::bench
