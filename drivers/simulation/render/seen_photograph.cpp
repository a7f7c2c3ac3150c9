#include "drivers/simulation/render/seen_photograph.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace pizarra::simulation {

namespace {

using Eigen::Vector3d;

constexpr double behind_table_mm = 500;  // room for the arm to reach back
// A pixel is looked at so often each way.
constexpr int looks = 2;

// Around `middle`, all of it shown where it is not longer than `along` says, mm to the right and down.
LaidPhotograph laid(const std::shared_ptr<const Photograph>& print, const Vector3d& middle, const Vector3d& right,
                    const Vector3d& down, const Eigen::Vector2d& along) {
  const double mm_per_pixel = std::max(along.x() / print->width(), along.y() / print->height());
  const Vector3d right_mm = right * mm_per_pixel;
  const Vector3d down_mm = down * mm_per_pixel;
  const Vector3d corner = middle - right_mm * (print->width() / 2.0) - down_mm * (print->height() / 2.0);
  return {print, corner, right_mm, down_mm};
}

}  // namespace

SeenPhotograph::SeenPhotograph(const Eye& eye, const LaidPhotograph& laid)
    : print_(laid.print),
      light_(laid.light),
      to_print_(eye.plane_to_pixels(laid.corner_mm, laid.right_mm, laid.down_mm).inverse()) {}

bool SeenPhotograph::is_ahead(int x, int y) const { return to_print_.row(2).dot(Vector3d(x, y, 1)) > 0; }

Eigen::Vector3f SeenPhotograph::at(int x, int y) const {
  const auto aside = [](int look) { return (look + 0.5) / looks - 0.5; };
  Eigen::Vector3f sum = Eigen::Vector3f::Zero();
  for (int i = 0; i < looks; ++i) {
    for (int j = 0; j < looks; ++j) {
      const Vector3d on = to_print_ * Vector3d(x + aside(i), y + aside(j), 1);
      const Eigen::Vector2d point = on.head<2>() / on.z();
      // How far the point moves in the photograph for a pixel across and for one down.
      const Eigen::Matrix2d moves = (to_print_.topLeftCorner<2, 2>() - point * to_print_.row(2).head<2>()) / on.z();
      sum += print_->at(point.x(), point.y(), std::sqrt(moves.colwise().squaredNorm().maxCoeff()) / looks);
    }
  }
  return light_ * sum / (looks * looks);
}

LaidPhotograph behind_the_table(const WorldConfig& config) {
  const Eye left = make_eye(config.camera, Side::left);
  const Eye right = make_eye(config.camera, Side::right);
  const Vector3d from = (left.position_mm + right.position_mm) / 2;
  const Vector3d forward = left.axes.row(2);
  const TableConfig& table = config.table;
  double farthest = 0;
  for (const double x : {table.x_low_mm, table.x_high_mm}) {
    for (const double y : {table.y_low_mm, table.y_high_mm}) {
      farthest = std::max(farthest, forward.dot(Vector3d(x, y, 0) - from));
    }
  }
  const double away = farthest + behind_table_mm;
  const Eigen::Vector2d seen(away * left.width / left.focal_px + config.camera.model.base_line_mm,
                             away * left.height / left.focal_px);
  return laid(config.background, from + forward * away, left.axes.row(0), left.axes.row(1), seen);
}

LaidPhotograph over_the_table(const WorldConfig& config) {
  const TableConfig& table = config.table;
  const Vector3d middle((table.x_low_mm + table.x_high_mm) / 2, (table.y_low_mm + table.y_high_mm) / 2, 0);
  return laid(config.table_picture, middle, Vector3d::UnitY(), Vector3d::UnitX(),
              {table.y_high_mm - table.y_low_mm, table.x_high_mm - table.x_low_mm});
}

}  // namespace pizarra::simulation
