#pragma once

// Squares and crosses of print that are projected from known poses, with nothing of the cell's renderers.
//
//   const LearnedSample sample = learned(square, random);
//   const cv::Mat1b image = filled(projected(square, turned_about({0, 0, 0.3}), {10, 5, 500}), random);

#include <opencv2/core.hpp>
#include <vector>

#include "agents/vision/objects/learned.hpp"
#include "agents/vision/sight/plane_view.hpp"
#include "blackboard/time/random.hpp"
#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

using Corners = std::vector<cv::Point2d>;

inline constexpr double half_mm = 20;
extern const Corners square;
extern const Corners cross;
Corners circle();

camera::StereoModel one_camera();
cv::Matx33d turned_about(const cv::Vec3d& rad);
// Of the ways that two planes face.
double degrees_between(const cv::Matx33d& a, const cv::Matx33d& b);
// Dark on light, each pixel the mean of what it covers, drawn so many times finer.
cv::Mat1b filled(const Corners& corners, Random& random, double noise = 1, int finer = 8);
Corners projected(const Corners& plane, const cv::Matx33d& turn, const cv::Vec3d& place);
// As a click on it from the front would. `light`: by how much of itself it grows over a pixel to the right.
LearnedSample learned(const Corners& plane, Random& random, double light = 0);

struct Registered {
  PlaneFit fit;
  PlanePose pose;
};
// Of the first region that shows the sample's outline.
std::optional<Registered> registered(const cv::Mat1b& image, const LearnedSample& sample);

}  // namespace pizarra::vision
