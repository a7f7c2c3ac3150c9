// How often what nobody learned is taken for what was: convex shapes alone, in the light, noise and sizes of the
// scenes; by one image, and, as FIND tells it, how surely before one camera and before a pair.

#include <fmt/format.h>
#include <map>

#include "agents/vision/sight/wholeness.hpp"
#include "tests/bench/vision/rows.hpp"
#include "tests/bench/vision/unlearned.hpp"

namespace pizarra::bench {
namespace {

constexpr double sure_from = 0.9;

// The learned object that the shape is taken for; and which of the two cameras are sure of one.
struct Taken {
  std::string name;
  bool surely_by_one = false;
  bool surely_by_pair = false;
};

bool is_sure(vision::StereoSight& sight, const vision::LearnedObjects& objects, const vision::LearnedObject& object) {
  const std::optional<vision::SeenPair> pair = sight.find(objects, object);
  return pair && vision::confidence_at_first(sight, object, *pair) >= sure_from;
}

Taken taken_for(const VisionBench& bench, const UnlearnedShape& shape, Random& random) {
  SceneRanges ranges = hard_ranges;
  ranges.presence = 0;
  ranges.most_clutter = 0;
  Scene scene = random_scene(ranges, random);
  const double scale = random.uniform(ranges.least_scale, ranges.most_scale);
  // Both images show it whole.
  const double depth_mm = learning_depth_mm / scale;
  const double left = std::min(60 + disparity_px(depth_mm), scene_camera().width - 70.0);
  const cv::Point2d at(random.uniform(left, scene_camera().width - 60), random.uniform(60, scene_camera().height - 60));
  const double turn = random.uniform(-ranges.most_turn_deg, ranges.most_turn_deg);
  scene.things = {
      {.shape = placed(shape.shape, at, scale_at(depth_mm), turn), .level = scene.mark_level, .depth_mm = depth_mm}};
  const cv::Mat1b image = draw(scene, Side::left, random);
  camera::StereoModel single = scene_camera();
  single.base_line_mm = 0;
  vision::StereoSight by_one(image, image, single);
  vision::StereoSight by_pair(image, draw(scene, Side::right, random), scene_camera());
  Taken out;
  for (const vision::LearnedObject& object : bench.marks.all()) {
    if (vision::find_object(by_one.left_segmentation().marks(), bench.marks, object) == nullptr) continue;
    if (out.name.empty()) out.name = object.name;
    out.surely_by_one = out.surely_by_one || is_sure(by_one, bench.marks, object);
    out.surely_by_pair = out.surely_by_pair || is_sure(by_pair, bench.marks, object);
  }
  return out;
}

}  // namespace

void unlearned(VisionBench& bench) {
  const int scenes = std::max(1, bench.scenes / 10);
  for (const UnlearnedShape& shape : unlearned_shapes()) {
    std::map<std::string, int> taken;
    int wrong = 0;
    int surely_by_one = 0;
    int surely_by_pair = 0;
    for (int i = 0; i < scenes; ++i) {
      Random random = Random(bench.seed).split(fmt::format("{} {}", shape.name, i));
      const Taken one = taken_for(bench, shape, random);
      if (one.name.empty()) continue;
      ++taken[one.name];
      ++wrong;
      surely_by_one += one.surely_by_one ? 1 : 0;
      surely_by_pair += one.surely_by_pair ? 1 : 0;
    }
    std::string note = fmt::format("in {} scenes", scenes);
    for (const auto& [name, count] : taken) note += fmt::format(", {} times for the {}", count, name);
    note += fmt::format("; {} of them told with a confidence of {} or more before one camera, {} before a pair",
                        surely_by_one, sure_from, surely_by_pair);
    bench.figures.say(
        {fmt::format("unlearned taken for learned: {}", shape.name), 100.0 * wrong / scenes, "%", {}, {}, note});
  }
}

}  // namespace pizarra::bench
