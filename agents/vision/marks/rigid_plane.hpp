#pragma once

// Holds a homography to the image of a plane that is not stretched, for a camera of known focal length. The two axes of
// the plane are as long as each other in space, and at a right angle. So a tilt that squeezes the image also makes its
// parallel lines meet. The sides of a mark that are seen thus say how far the hidden ones are.
//
//   hold_rigid(normal, right, to_image, {.focal_px = 600, .axis = {319.5, 239.5}});    // in each Gauss-Newton step
//
// Nothing is held where the focal length is not known.

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace pizarra::vision {

struct PlaneLens {
  double focal_px = 0;  // 0: not known
  cv::Point2d axis;     // where the camera's axis meets the image, px
  // By how much of their mean one axis may still be the longer one: a standard deviation.
  double stretch_spread = 0.002;
};

// Adds to the equations of a step on the first eight numbers of `to_image`, whose ninth is 1.
void hold_rigid(Eigen::Matrix<double, 8, 8>& normal, Eigen::Matrix<double, 8, 1>& right, const cv::Matx33d& to_image,
                const PlaneLens& lens);

}  // namespace pizarra::vision
