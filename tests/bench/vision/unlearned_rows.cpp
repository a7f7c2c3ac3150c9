// How often what nobody learned is taken for what was: convex shapes alone, in the light, noise and sizes of the
// scenes.

#include <fmt/format.h>
#include <map>

#include "tests/bench/vision/rows.hpp"
#include "tests/bench/vision/unlearned.hpp"

namespace pizarra::bench {
namespace {

constexpr double sure_from = 0.9;

// The learned object that the shape is taken for, and how sure that is.
struct Taken {
  std::string name;
  double confidence;
};

std::optional<Taken> taken_for(const VisionBench& bench, const UnlearnedShape& shape, Random& random) {
  SceneRanges ranges = hard_ranges;
  ranges.presence = 0;
  ranges.most_clutter = 0;
  Scene scene = random_scene(ranges, random);
  const double scale = random.uniform(ranges.least_scale, ranges.most_scale) * scale_at(learning_depth_mm);
  const cv::Point2d at(random.uniform(60, scene_camera().width - 60), random.uniform(60, scene_camera().height - 60));
  const double turn = random.uniform(-ranges.most_turn_deg, ranges.most_turn_deg);
  scene.things = {{.shape = placed(shape.shape, at, scale, turn), .level = scene.mark_level}};
  ImageSegmentation segmentation(draw(scene, Side::left, random));
  for (const LearnedObject& object : bench.marks.all()) {
    const SeenMark* seen = find_object(segmentation.marks(), bench.marks, object);
    if (seen != nullptr) return Taken{object.name, likeness(*seen, bench.marks, object).confidence()};
  }
  return std::nullopt;
}

}  // namespace

void unlearned(VisionBench& bench) {
  const int scenes = std::max(1, bench.scenes / 10);
  for (const UnlearnedShape& shape : unlearned_shapes()) {
    std::map<std::string, int> taken;
    int wrong = 0;
    int sure = 0;
    for (int i = 0; i < scenes; ++i) {
      Random random = Random(bench.seed).split(fmt::format("{} {}", shape.name, i));
      const std::optional<Taken> one = taken_for(bench, shape, random);
      if (!one) continue;
      ++taken[one->name];
      ++wrong;
      sure += one->confidence >= sure_from ? 1 : 0;
    }
    std::string note = fmt::format("in {} scenes", scenes);
    for (const auto& [name, count] : taken) note += fmt::format(", {} times for the {}", count, name);
    note += fmt::format("; {} of them with a confidence of {} or more", sure, sure_from);
    bench.figures.say(
        {fmt::format("unlearned taken for learned: {}", shape.name), 100.0 * wrong / scenes, "%", {}, {}, note});
  }
}

}  // namespace pizarra::bench
