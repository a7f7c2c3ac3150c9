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

// Of what stretches a circle so: `m` is symmetric, the stretch times its transpose. `size` is the determinant of the
// stretch.
FrontView front_view(const cv::Matx22d& m, double size, double area_mm2) {
  const double half = std::min(1.0, 2 * size / cv::trace(m));
  const double axis = std::atan2(2 * m(0, 1), m(0, 0) - m(1, 1)) / 2 * 180 / std::numbers::pi;
  return {.area_mm2 = area_mm2,
          .slimness = half / (1 + std::sqrt(1 - half * half)),
          .axis_deg = axis > 0 ? axis : axis + 180};
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
// along the line of sight. So J J' = (f / Z)^2 P (1 - n n') P'. The inverse of J leads from the image to the front.
// After the way from the picture to the image, T, it stretches the picture along the axes of T' (J J')^-1 T.
FrontView view_from_front(const camera::StereoModel& model, const FacePlane& plane, const cv::Matx22d& to_image) {
  const double mm_per_px = depth_mm(model, plane.along_sight * model.focal_px) / model.focal_px;
  const double across = plane.across - plane.ahead * plane.x;
  const double down = plane.down - plane.ahead * plane.y;
  const double n2 = plane.normal2();
  const double xx = 1 + plane.x * plane.x - across * across / n2;
  const double xy = plane.x * plane.y - across * down / n2;
  const double yy = 1 + plane.y * plane.y - down * down / n2;
  const double shown = plane.along_sight / std::sqrt(n2);  // the root of the determinant
  const cv::Matx22d to_front2 = cv::Matx22d(yy, -xy, -xy, xx) * (1 / (shown * shown));
  const double size = std::abs(cv::determinant(to_image)) / shown;
  return front_view(to_image.t() * to_front2 * to_image, size, size * mm_per_px * mm_per_px);
}

FrontView view_as_seen(const cv::Matx22d& to_image, double mm_per_px) {
  const double size = std::abs(cv::determinant(to_image));
  return front_view(to_image.t() * to_image, size, size * mm_per_px * mm_per_px);
}

cv::Matx22d to_image_of(const SeenMark& seen) {
  return root_of({seen.width_px * seen.width_px, seen.slant_px2, seen.slant_px2, seen.height_px * seen.height_px});
}

}  // namespace pizarra::vision
