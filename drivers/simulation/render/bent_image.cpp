#include "drivers/simulation/render/bent_image.hpp"

#include <opencv2/imgproc.hpp>

#include "drivers/simulation/camera_lens.hpp"

namespace pizarra::simulation {

namespace {

constexpr int bend_reach = 1;  // px around a place that its level is made of

cv::Rect cv_rect(const Rect& rect) { return {rect.left, rect.top, rect.right - rect.left, rect.bottom - rect.top}; }

}  // namespace

BentImage::BentImage(const CameraConfig& camera)
    : straight_(camera.model),
      columns_(camera.model.height, camera.model.width),
      rows_(camera.model.height, camera.model.width) {
  const camera::StereoModel& model = camera.model;
  for (int y = 0; y < model.height; ++y) {
    for (int x = 0; x < model.width; ++x) {
      const Eigen::Vector2d point((x - model.centre_x_px) / model.focal_px, (y - model.centre_y_px) / model.focal_px);
      const Eigen::Vector2d straight = undistorted(camera.lens, point).value();
      columns_(y, x) = static_cast<float>(model.centre_x_px + model.focal_px * straight.x());
      rows_(y, x) = static_cast<float>(model.centre_y_px + model.focal_px * straight.y());
    }
  }
  double left = 0;
  double right = 0;
  double top = 0;
  double bottom = 0;
  cv::minMaxLoc(columns_, &left, &right);
  cv::minMaxLoc(rows_, &top, &bottom);
  const int shift_right = bend_reach - cvFloor(left);
  const int shift_down = bend_reach - cvFloor(top);
  columns_ += shift_right;
  rows_ += shift_down;
  straight_.centre_x_px += shift_right;
  straight_.centre_y_px += shift_down;
  straight_.width = cvCeil(right) + shift_right + bend_reach + 1;
  straight_.height = cvCeil(bottom) + shift_down + bend_reach + 1;
}

Rect BentImage::showing(const Rect& straight) const {
  const Rect wide = straight.grown(bend_reach);
  Rect out;
  for (int y = 0; y < rows_.rows; ++y) {
    for (int x = 0; x < rows_.cols; ++x) {
      const float column = columns_(y, x);
      const float row = rows_(y, x);
      const bool inside = column >= static_cast<float>(wide.left) && column < static_cast<float>(wide.right) &&
                          row >= static_cast<float>(wide.top) && row < static_cast<float>(wide.bottom);
      if (inside) out = out.united({x, y, x + 1, y + 1});
    }
  }
  return out;
}

void BentImage::bend(const Canvas& straight, const Rect& rect, Canvas& bent) const {
  if (rect.empty()) return;
  const int type = CV_MAKETYPE(CV_32F, bent.channels);
  // Only read.
  const cv::Mat from(straight.height, straight.width, type, const_cast<float*>(straight.pixels.data()));
  cv::Mat to = cv::Mat(bent.height, bent.width, type, bent.pixels.data())(cv_rect(rect));
  cv::remap(from, to, columns_(cv_rect(rect)), rows_(cv_rect(rect)), cv::INTER_LINEAR, cv::BORDER_REPLICATE);
}

}  // namespace pizarra::simulation
