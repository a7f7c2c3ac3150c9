#pragma once

// From a pair of image points to distances, for a rectified pair.

#include <opencv2/core.hpp>

#include "drivers/camera/stereo_camera.hpp"

namespace pizarra {

// Along the optical axis, mm. The disparity is positive; one camera alone has none.
double depth_mm(const StereoModel& model, double disparity_px);

// From the middle of the base line to the point seen at `left`, mm: a range, not the depth along the axis.
double range_mm(const StereoModel& model, cv::Point2d left, double disparity_px);
// The same where the depth is known.
double range_at_depth_mm(const StereoModel& model, cv::Point2d left, double depth_mm);

// How far range_mm() may be off, as a standard deviation, where the disparity may be off by `disparity_spread_px`:
// depth is f b / d, so that it varies by Z^2 / (f b) a pixel (L. Matthies, S. Shafer, Error modeling in stereo
// navigation, IEEE Journal of Robotics and Automation 3(3), 1987), and the range with it.
double range_spread_mm(const StereoModel& model, cv::Point2d left, double disparity_px, double disparity_spread_px);

}  // namespace pizarra
