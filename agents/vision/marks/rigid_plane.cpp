#include "agents/vision/marks/rigid_plane.hpp"

namespace pizarra::vision {
namespace {

using Eigen::Vector3d;
using Vector8 = Eigen::Matrix<double, 8, 1>;

// One axis of the plane in the camera's frame, but for a factor that both have in common.
Vector3d axis_in_space(const cv::Matx33d& to_image, int column, const PlaneLens& lens) {
  const double depth = to_image(2, column);
  return {(to_image(0, column) - lens.axis.x * depth) / lens.focal_px,
          (to_image(1, column) - lens.axis.y * depth) / lens.focal_px, depth};
}

// How the product of an axis with `with` goes with the axis' numbers: of column 0 they are 0, 3 and 6.
void add_product(Vector8& by, int column, const Vector3d& with, const PlaneLens& lens) {
  by[column] += with.x() / lens.focal_px;
  by[column + 3] += with.y() / lens.focal_px;
  by[column + 6] += with.z() - (lens.axis.x * with.x() + lens.axis.y * with.y()) / lens.focal_px;
}

}  // namespace

void hold_rigid(Eigen::Matrix<double, 8, 8>& normal, Vector8& right, const cv::Matx33d& to_image,
                const PlaneLens& lens) {
  if (lens.focal_px <= 0) return;
  const Vector3d x = axis_in_space(to_image, 0, lens);
  const Vector3d y = axis_in_space(to_image, 1, lens);
  const double squares = x.squaredNorm() + y.squaredNorm();
  const double known = 1 / (lens.stretch_spread * lens.stretch_spread);
  const auto hold = [&](const Vector8& by, double off) {
    normal += known * by * by.transpose();
    right -= known * off * by;
  };
  Vector8 longer = Vector8::Zero();
  add_product(longer, 0, 2 / squares * x, lens);
  add_product(longer, 1, -2 / squares * y, lens);
  hold(longer, (x.squaredNorm() - y.squaredNorm()) / squares);
  Vector8 slanted = Vector8::Zero();
  add_product(slanted, 0, 2 / squares * y, lens);
  add_product(slanted, 1, 2 / squares * x, lens);
  hold(slanted, 2 * x.dot(y) / squares);
}

}  // namespace pizarra::vision
