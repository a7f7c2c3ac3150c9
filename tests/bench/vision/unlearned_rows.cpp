// How often what nobody learned is taken for what was: convex shapes alone, in the light, noise and sizes of the
// scenes, as FIND tells it before one camera and before a pair.

#include <array>
#include <fmt/format.h>
#include <map>

#include "agents/vision/sight/mark_finder.hpp"
#include "tests/bench/vision/rows.hpp"
#include "tests/bench/vision/unlearned.hpp"

namespace pizarra::bench {
namespace {

constexpr double sure_from = 0.9;
// Of narrower ones the blur and the noise of these scenes hide what they differ by.
constexpr double wide_px = 20;
constexpr double width_mm = 44;

// How often FIND told a learned object where the shape was.
struct Taken {
  int scenes = 0;
  int at_all = 0;
  int surely = 0;
  std::map<std::string, int> by_name;

  void look(vision::StereoSight& sight, const vision::LearnedObjects& objects) {
    vision::MarkFinder finder(objects);
    bool any = false;
    bool sure = false;
    for (const vision::LearnedObject& object : objects.all()) {
      const Result<vision::FoundMark> found = finder.find(sight, object, {});
      if (!found) continue;
      ++by_name[object.name];
      any = true;
      sure = sure || found->confidence >= sure_from;
    }
    ++scenes;
    at_all += any ? 1 : 0;
    surely += sure ? 1 : 0;
  }
  double percent(int count) const { return 100.0 * count / std::max(1, scenes); }
  std::string note() const {
    std::string out = fmt::format("in {} scenes", scenes);
    for (const auto& [name, count] : by_name) out += fmt::format(", {} times for the {}", count, name);
    return out;
  }
};

struct Images {
  double width_px;
  cv::Mat1b left;
  cv::Mat1b right;
};

Images images_of(const UnlearnedShape& shape, Random& random) {
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
  cv::Mat1b left_image = draw(scene, Side::left, random);
  return {width_mm * scale_at(depth_mm), std::move(left_image), draw(scene, Side::right, random)};
}

// Those that are narrow and those that are wide.
using BySize = std::array<Taken, 2>;

void say(Figures& figures, const std::string& who, const UnlearnedShape& shape, bool is_none, const BySize& taken) {
  const auto& [narrow, wide] = taken;
  const std::string name = fmt::format("unlearned, {}: {}, taken", who, shape.name);
  figures.say({name,
               wide.percent(wide.at_all),
               "%",
               is_none ? at_most(2) : Goal{},
               {},
               fmt::format("{}; narrower than {} px {:.2f} %", wide.note(), wide_px, narrow.percent(narrow.at_all))});
  figures.say({name + " surely",
               wide.percent(wide.surely),
               "%",
               is_none ? at_most(0.1) : Goal{},
               {},
               fmt::format("narrower {:.2f} %", narrow.percent(narrow.surely))});
}

}  // namespace

// The goals are for shapes that these cameras can tell from every view of a mark.
void unlearned(VisionBench& bench) {
  const int scenes = std::max(1, bench.scenes / 10);
  camera::StereoModel single = scene_camera();
  single.base_line_mm = 0;
  for (const UnlearnedShape& shape : unlearned_shapes()) {
    BySize by_one;
    BySize by_pair;
    for (int i = 0; i < scenes; ++i) {
      Random random = Random(bench.seed).split(fmt::format("{} {}", shape.name, i));
      const Images images = images_of(shape, random);
      const std::size_t size = images.width_px < wide_px ? 0 : 1;
      vision::StereoSight one(images.left, images.left, single);
      vision::StereoSight pair(images.left, images.right, scene_camera());
      by_one[size].look(one, bench.marks);
      by_pair[size].look(pair, bench.marks);
    }
    say(bench.figures, "one camera", shape, shape.no_view_of_a_mark, by_one);
    say(bench.figures, "a pair", shape, true, by_pair);
  }
}

}  // namespace pizarra::bench
