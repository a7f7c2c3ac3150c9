// How often what nobody learned is taken for what was: convex shapes alone, in the light, noise and sizes of the
// scenes.

#include <fmt/format.h>
#include <map>

#include "tests/bench/vision/rows.hpp"
#include "tests/bench/vision/unlearned.hpp"

namespace pizarra::bench {
namespace {

// The learned object that the shape is taken for, if any.
std::string taken_for(const VisionBench& bench, const UnlearnedShape& shape, Random& random) {
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
    if (find_object(segmentation.marks(), bench.marks, object) != nullptr) return object.name;
  }
  return "";
}

}  // namespace

void unlearned(VisionBench& bench) {
  const int scenes = std::max(1, bench.scenes / 10);
  for (const UnlearnedShape& shape : unlearned_shapes()) {
    std::map<std::string, int> taken;
    int wrong = 0;
    for (int i = 0; i < scenes; ++i) {
      Random random = Random(bench.seed).split(fmt::format("{} {}", shape.name, i));
      const std::string name = taken_for(bench, shape, random);
      if (name.empty()) continue;
      ++taken[name];
      ++wrong;
    }
    std::string note = fmt::format("in {} scenes", scenes);
    for (const auto& [name, count] : taken) note += fmt::format(", {} times for the {}", count, name);
    bench.figures.say(
        {fmt::format("unlearned taken for learned: {}", shape.name), 100.0 * wrong / scenes, "%", {}, {}, note});
  }
}

}  // namespace pizarra::bench
