#pragma once

// From a pair of image points to distances, for a rectified pair.

#include <opencv2/core.hpp>

#include "drivers/camera/stereo_camera.hpp"

namespace pizarra::vision {

// Along the optical axis, mm. The disparity is positive; one camera alone has none.
double depth_mm(const camera::StereoModel& model, double disparity_px);
double disparity_px(const camera::StereoModel& model, double depth_mm);

// From the middle of the base line to the point seen at `left`, mm: a range, not the depth along the axis.
double range_mm(const camera::StereoModel& model, cv::Point2d left, double disparity_px);
// The same where the depth is known.
double range_at_depth_mm(const camera::StereoModel& model, cv::Point2d left, double depth_mm);

}  // namespace pizarra::vision
