#include "agents/vision/sight/stereo.hpp"

#include <cassert>
#include <cmath>

namespace pizarra::vision {

double depth_mm(const camera::StereoModel& model, double disparity_px) {
  assert(disparity_px > 0);
  return model.focal_px * model.base_line_mm / disparity_px;
}

double disparity_px(const camera::StereoModel& model, double depth) {
  assert(depth > 0);
  return model.focal_px * model.base_line_mm / depth;
}

double range_mm(const camera::StereoModel& model, cv::Point2d left, double disparity_px) {
  return range_at_depth_mm(model, left, depth_mm(model, disparity_px));
}

double range_at_depth_mm(const camera::StereoModel& model, cv::Point2d left, double depth) {
  const double x = (left.x - model.centre_x_px) * depth / model.focal_px - model.base_line_mm / 2;
  const double y = (left.y - model.centre_y_px) * depth / model.focal_px;
  return std::sqrt(x * x + y * y + depth * depth);
}

}  // namespace pizarra::vision
