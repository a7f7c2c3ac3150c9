#pragma once

// Scenes for the eyes, drawn from a seed: marks and tags on light ground, clutter, light, blur and noise, and the
// camera that sees them. Only the marks' outlines are common with the cell; its renderer and its camera have no part in
// this.
//
//   Random random(7);
//   Scene scene = random_scene(hard_conditions, random);
//   cv::Mat left = draw(scene, Side::left, random);
//   scene.marks[0].centre                                 // the truth, px of the left image

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "drivers/camera/stereo_camera.hpp"
#include "tests/bench/vision/outline.hpp"

namespace pizarra::bench {

inline constexpr double learning_depth_mm = 850;  // where a mark has scale 1

struct SceneMark {
  std::string name;    // of mark_shape(), or "end-effector": a light triangle on a dark plate
  cv::Point2d centre;  // of the mark's centroid, px of the left image
  double depth_mm = learning_depth_mm;
  double turn_deg = 0;
  cv::Mat1b tag = {};  // non-empty: a tag's dark cells instead of the mark
};

// Anything else that lies about or hides a mark. It is drawn after the marks when it is in front of them.
struct SceneThing {
  Shape shape;  // px of the left image
  double level = 0;
  double depth_mm = learning_depth_mm;
  bool in_front = false;
};

// What the levels are multiplied with: it changes evenly over the image. At 1.6 the ground is just not overexposed.
struct SceneLight {
  double centre = 1;
  cv::Point2d slope_per_px = {};
  double least = 0.4;
  double most = 1.6;
};

struct Scene {
  std::vector<SceneMark> marks;
  std::vector<SceneThing> things;
  SceneLight light;
  double blur_px = 0.7;
  double noise = 3;  // grey levels, standard deviation
  double ground_level = 160;
  double mark_level = 25;
};

// The ranges a random scene is drawn from.
struct SceneRanges {
  double least_light = 1, most_light = 1;
  double least_scale = 1, most_scale = 1;
  double most_turn_deg = 0;
  double most_noise = 3;
  double least_blur_px = 0.5, most_blur_px = 0.7;
  int most_clutter = 0;
  bool solids = false;  // solid convex things among the clutter
  double presence = 1;  // the chance that a mark is in the scene
};

inline constexpr SceneRanges hard_ranges = {
    .least_light = 0.4,
    .most_light = 1.6,
    .least_scale = 0.6,
    .most_scale = 1.6,
    .most_turn_deg = 30,
    .most_noise = 15,
    .least_blur_px = 0,
    .most_blur_px = 1.5,
    .most_clutter = 10,
    .presence = 0.9,
};

// circle, square, cross, triangle, end-effector.
const std::vector<std::string>& scene_marks();

// What scenes are drawn with: a camera, its focal length from 400 to 460 px, its base line from 60 to 95 mm, its centre
// up to 4 px beside the image's; and the sensor's noise. Both are drawn from a seed: 1, until another is set.
void set_scene_seed(std::uint64_t seed);
const camera::StereoModel& scene_camera();
// Its left one, where objects are learned at learning_depth_mm.
camera::StereoModel scene_camera_alone();

// The marks that are present do not touch one another, the clutter or the border of either image.
Scene random_scene(const SceneRanges& ranges, Random& random);
// The same places, turns and scales with tags: one for each mark.
Scene with_tags(Scene scene, const std::vector<cv::Mat1b>& tags);

enum class Side : std::uint8_t { left, right };

double disparity_px(double depth_mm);
// Pixels a mm at that depth.
double scale_at(double depth_mm);

// 8 bit. Draws what is random (noise) from `random`.
cv::Mat1b draw(const Scene& scene, Side side, Random& random);

}  // namespace pizarra::bench
