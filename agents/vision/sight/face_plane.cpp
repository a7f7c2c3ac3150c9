#include "agents/vision/sight/face_plane.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/vision/marks/covariance.hpp"
#include "agents/vision/sight/covered_part.hpp"

namespace pizarra::vision {
namespace {

// The value, shrunk towards 0 by as much as noise of this spread may make it.
double beyond_noise(double value, double spread) {
  return value == 0 ? 0 : value * std::max(0.0, 1 - spread * spread / (value * value));
}

cv::Matx22d covariance_of(const SeenMark& mark) {
  return {mark.width_px * mark.width_px, mark.slant_px2, mark.slant_px2, mark.height_px * mark.height_px};
}

// Of the ellipse with this covariance.
double axis_deg_of(const cv::Matx22d& m) {
  const double axis = std::atan2(2 * m(0, 1), m(0, 0) - m(1, 1)) / 2 * 180 / std::numbers::pi;
  return axis > 0 ? axis : axis + 180;
}

}  // namespace

double FacePlane::shown_height() const {
  const double beside_sight = down - ahead * y;
  return std::sqrt(1 + y * y - beside_sight * beside_sight / normal2());
}

FacePlane face_plane(const camera::StereoModel& model, const SeenMark& left, const SeenMark& right) {
  FacePlane out{};
  out.x = (left.centre.x - model.centre_x_px) / model.focal_px;
  out.y = (left.centre.y - model.centre_y_px) / model.focal_px;
  out.along_sight = (left.centre.x - right.centre.x) / model.focal_px;
  const double squeezed = spread_product_px2(right) / right.height_px / (spread_product_px2(left) / left.height_px);
  const double sheared = (squeezed * left.slant_px2 - right.slant_px2) / (left.height_px * right.height_px);
  out.across = 1 - squeezed;
  out.across_spread = std::numbers::sqrt2 * centre_spread_px(left, left.noise) / left.width_px;
  out.down_spread = out.across_spread * left.width_px / left.height_px;
  out.down = beyond_noise(sheared, out.down_spread);
  out.ahead = out.along_sight - out.across * out.x - out.down * out.y;
  return out;
}

double yaw_deg(const FacePlane& plane) {
  return plane.ahead <= 0 ? 0 : -std::atan(plane.across / plane.ahead) * 180 / std::numbers::pi;
}

// A plane's image is J times it, J = f / Z P E: E are two unit vectors along the plane, and P projects a step in space
// along the line of sight. So J J' = (f / Z)^2 P (1 - n n') P'. With it the trace and the determinant of the covariance
// from the front follow from the image's, however the plane's own axes lie. From the mark whose moments are a circle's,
// the root of its covariance leads to the image, and the inverse of J to the front: their product stretches it along
// the axes of C (J J')^-1 C, where C is that root.
FrontView view_from_front(const camera::StereoModel& model, const FacePlane& plane, const SeenMark& left) {
  const double mm_per_px = depth_mm(model, plane.along_sight * model.focal_px) / model.focal_px;
  const double across = plane.across - plane.ahead * plane.x;
  const double down = plane.down - plane.ahead * plane.y;
  const double n2 = plane.normal2();
  const double xx = 1 + plane.x * plane.x - across * across / n2;
  const double xy = plane.x * plane.y - across * down / n2;
  const double yy = 1 + plane.y * plane.y - down * down / n2;
  const double shown = plane.along_sight / std::sqrt(n2);  // the root of the determinant
  const double trace =
      (yy * left.width_px * left.width_px - 2 * xy * left.slant_px2 + xx * left.height_px * left.height_px) /
      (shown * shown);
  const double product = spread_product_px2(left) / shown;
  const double half = std::min(1.0, 2 * product / trace);
  const cv::Matx22d to_image = root_of(covariance_of(left));
  return {.area_mm2 = product * mm_per_px * mm_per_px,
          .slimness = half / (1 + std::sqrt(1 - half * half)),
          .axis_deg = axis_deg_of(to_image * cv::Matx22d(yy, -xy, -xy, xx) * to_image)};
}

FrontView view_as_seen(const SeenMark& seen, double mm_per_px) {
  return {spread_product_px2(seen) * mm_per_px * mm_per_px, seen.slimness, axis_deg_of(covariance_of(seen))};
}

}  // namespace pizarra::vision
