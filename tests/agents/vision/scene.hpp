#pragma once

// Test scenes drawn from first principles: white cube faces with marks on a grey ground, seen by a rectified pair,
// with blur, sensor noise and a light gradient. Lengths mm; the camera looks along depth, x right, y down, origin at
// the middle of the base line.

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "blackboard/time/random.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

struct SceneFace {
  // circle, square, cross, triangle, bar (twice as wide as high), thin-bar (three times), none, or plate: a white
  // triangle on a dark plate
  std::string mark;
  cv::Point3d place;      // of the mark's centroid
  double yaw_deg = 0;     // about the vertical
  int quarter_turns = 0;  // about the line of sight
  double roll_deg = 0;    // the same, small
  double pitch_deg = 0;   // then about the horizontal, the upper edge away
  double scale = 1;       // of the mark
};

struct SceneBlot {
  cv::Rect2d box;  // px of the left image, drawn over everything
  int level = 0;
  double disparity_px = 60;  // 45 is as far away as the cubes, 60 is 200 mm nearer
  double turn_deg = 0;       // about the middle of the box
};

struct Scene {
  std::vector<SceneFace> faces;  // far ones first
  std::vector<SceneBlot> blots = {};
  double gradient = 0.3;  // the share of light lost from the left edge to the right one
  double noise = 3;       // grey levels
  double blur_px = 0.7;
  int ground = 120;
};

// Where a point is seen, px.
cv::Point2d project(const camera::StereoModel& model, const cv::Point3d& point, bool right);

camera::StereoFrame draw_scene(const Scene& scene, const camera::StereoModel& model, std::uint64_t number,
                               Random& random);

// A copy.
cv::Mat as_mat(const Image& image);

}  // namespace pizarra::vision
