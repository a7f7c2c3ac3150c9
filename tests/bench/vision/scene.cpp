#include "tests/bench/vision/scene.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "tests/bench/vision/clutter.hpp"

namespace pizarra::bench {
namespace {

constexpr double light_reach_mm = 40;  // around a mark's centroid, its plate and some ground included
constexpr double plate_level = 45;

void paint_mark(cv::Mat1f& image, const Scene& scene, const SceneMark& mark, cv::Point2d at) {
  const double scale = scale_at(mark.depth_mm);
  const auto fill = [&](const Shape& shape, double level) {
    paint(image, placed(shape, at, scale, mark.turn_deg), static_cast<float>(level));
  };
  if (!mark.tag.empty()) {
    fill(tag_shape(mark.tag, 44), scene.mark_level);
  } else if (mark.name == "end-effector") {
    fill(mark_shape("plate"), plate_level);
    fill(mark_shape("triangle"), scene.ground_level);
  } else {
    fill(mark_shape(mark.name), scene.mark_level);
  }
}

cv::Point2d seen_at(cv::Point2d left, double depth_mm, Side side) {
  return side == Side::left ? left : left - cv::Point2d(disparity_px(depth_mm), 0);
}

void paint_things(cv::Mat1f& image, const Scene& scene, bool in_front, Side side) {
  for (const SceneThing& thing : scene.things) {
    if (thing.in_front != in_front) continue;
    paint(image, placed(thing.shape, seen_at({0, 0}, thing.depth_mm, side), 1, 0), static_cast<float>(thing.level));
  }
}

camera::StereoModel random_camera(Random random) {
  camera::StereoModel out{.width = 320, .height = 240};
  out.focal_px = random.uniform(400, 460);
  out.base_line_mm = random.uniform(60, 95);
  out.centre_x_px = 159.5 + random.uniform(-4, 4);
  out.centre_y_px = 119.5 + random.uniform(-4, 4);
  return out;
}

struct Sensor {
  camera::StereoModel camera;
  std::vector<float> normal;  // numbers drawn once; each image reads them from places of its own

  explicit Sensor(std::uint64_t seed) : camera(random_camera(Random(seed).split("camera"))), normal(1 << 17) {
    Random random = Random(seed).split("noise");
    for (float& number : normal) number = static_cast<float>(random.normal());
  }
};

Sensor& sensor() {
  static Sensor used(1);
  return used;
}

cv::Mat1b exposed(const cv::Mat1f& image, const Scene& scene, Random& random) {
  const std::vector<float>& normal = sensor().normal;
  cv::Mat1b out(image.size());
  for (int y = 0; y < image.rows; ++y) {
    const float* noise = normal.data() + random.below(normal.size() - static_cast<std::size_t>(image.cols));
    for (int x = 0; x < image.cols; ++x) {
      const double away = scene.light.slope_per_px.dot({x - image.cols / 2.0, y - image.rows / 2.0});
      const double light = std::clamp(scene.light.centre + away, scene.light.least, scene.light.most);
      out(y, x) = cv::saturate_cast<std::uint8_t>(image(y, x) * light + scene.noise * noise[x]);
    }
  }
  return out;
}

// Where both images show the whole of a mark that reaches `reach_px`, and nothing placed before it is touched.
std::optional<SceneMark> free_place(const std::vector<SceneMark>& others, SceneMark mark, Random& random) {
  const auto reach = [](const SceneMark& m) { return light_reach_mm * scale_at(m.depth_mm); };
  const camera::StereoModel& camera = scene_camera();
  const double margin = reach(mark) + 2;
  const double left_margin = std::min(margin + disparity_px(mark.depth_mm), camera.width - margin - 1);
  for (int attempt = 0; attempt < 60; ++attempt) {
    mark.centre = {random.uniform(left_margin, camera.width - margin), random.uniform(margin, camera.height - margin)};
    const bool free = std::ranges::none_of(others, [&](const SceneMark& other) {
      const double least = reach(mark) + reach(other);
      return cv::norm(mark.centre - other.centre) < least ||
             cv::norm(seen_at(mark.centre, mark.depth_mm, Side::right) -
                      seen_at(other.centre, other.depth_mm, Side::right)) < least;
    });
    if (free) return mark;
  }
  return std::nullopt;
}

SceneLight random_light(const SceneRanges& ranges, Random& random) {
  SceneLight light;
  light.least = ranges.least_light;
  light.most = ranges.most_light;
  light.centre = random.uniform(ranges.least_light, ranges.most_light);
  const double across = random.uniform(-0.5, 0.5) * (ranges.most_light - ranges.least_light);
  const double direction = random.uniform(0, CV_PI);
  light.slope_per_px = across / scene_camera().width * cv::Point2d(std::cos(direction), std::sin(direction));
  return light;
}

}  // namespace

const std::vector<std::string>& scene_marks() {
  static const std::vector<std::string> names = {"circle", "square", "cross", "triangle", "end-effector"};
  return names;
}

void set_scene_seed(std::uint64_t seed) { sensor() = Sensor(seed); }

const camera::StereoModel& scene_camera() { return sensor().camera; }

camera::StereoModel scene_camera_alone() {
  camera::StereoModel out = scene_camera();
  out.base_line_mm = 0;
  out.learned_at_mm = learning_depth_mm;
  return out;
}

double disparity_px(double depth_mm) { return scene_camera().focal_px * scene_camera().base_line_mm / depth_mm; }

double scale_at(double depth_mm) { return scene_camera().focal_px / depth_mm; }

Scene random_scene(const SceneRanges& ranges, Random& random) {
  Scene scene;
  scene.light = random_light(ranges, random);
  scene.noise = random.uniform(0, ranges.most_noise);
  scene.blur_px = random.uniform(ranges.least_blur_px, ranges.most_blur_px);
  for (const std::string& name : scene_marks()) {
    if (random.uniform(0, 1) >= ranges.presence) continue;
    const double scale = random.uniform(ranges.least_scale, ranges.most_scale);
    const double turn = random.uniform(-ranges.most_turn_deg, ranges.most_turn_deg);
    const SceneMark mark{.name = name, .centre = {}, .depth_mm = learning_depth_mm / scale, .turn_deg = turn};
    const std::optional<SceneMark> placed_mark = free_place(scene.marks, mark, random);
    if (placed_mark) scene.marks.push_back(*placed_mark);
  }
  add_clutter(scene, ranges.most_clutter, ranges.solids, random);
  return scene;
}

Scene with_tags(Scene scene, const std::vector<cv::Mat1b>& tags) {
  for (std::size_t i = 0; i < scene.marks.size(); ++i) scene.marks[i].tag = tags[i % tags.size()];
  return scene;
}

cv::Mat1b draw(const Scene& scene, Side side, Random& random) {
  const camera::StereoModel& camera = scene_camera();
  cv::Mat1f image(camera.height, camera.width, static_cast<float>(scene.ground_level));
  paint_things(image, scene, false, side);
  for (const SceneMark& mark : scene.marks) {
    paint_mark(image, scene, mark, seen_at(mark.centre, mark.depth_mm, side));
  }
  paint_things(image, scene, true, side);
  if (scene.blur_px > 0.1) cv::GaussianBlur(image, image, {11, 11}, scene.blur_px, scene.blur_px, cv::BORDER_REPLICATE);
  return exposed(image, scene, random);
}

}  // namespace pizarra::bench
