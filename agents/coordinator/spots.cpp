#include "agents/coordinator/spots.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pizarra {

std::optional<Eigen::Vector2d> free_spot(const TableArea& area, const std::vector<Eigen::Vector2d>& occupied,
                                         double from_y_mm) {
  std::optional<Eigen::Vector2d> nearest;
  std::optional<Eigen::Vector2d> roomiest;
  double best_distance = std::numeric_limits<double>::infinity();
  double best_room = area.least_mm;
  for (double y = area.y_low_mm; y <= area.y_high_mm; y += area.grid_mm) {
    double room = std::numeric_limits<double>::infinity();
    for (const Eigen::Vector2d& other : occupied) {
      if (std::abs(other.x() - area.x_mm) < area.depth_mm) room = std::min(room, std::abs(other.y() - y));
    }
    const double distance = std::abs(y - from_y_mm);
    if (room >= area.comfortable_mm && distance < best_distance) {
      best_distance = distance;
      nearest = {area.x_mm, y};
    }
    if (room >= best_room) {
      best_room = room + 1e-9;
      roomiest = {area.x_mm, y};
    }
  }
  return nearest ? nearest : roomiest;
}

double opening_between(const Eigen::Vector3d& centre, const std::vector<Eigen::Vector3d>& neighbours, double cube_mm,
                       double finger_mm, double narrow_mm, double wide_mm) {
  constexpr double margin_mm = 4;
  double opening = wide_mm;
  for (const Eigen::Vector3d& other : neighbours) {
    const Eigen::Vector3d apart = (other - centre).cwiseAbs();
    // What stands behind, before or well below cannot meet the fingers.
    const bool beside = apart.x() < 0.75 * cube_mm && other.z() > centre.z() - 0.75 * cube_mm;
    if (!beside || apart.y() < cube_mm / 2) continue;
    opening = std::min(opening, 2 * (apart.y() - cube_mm / 2 - finger_mm - margin_mm));
  }
  return std::clamp(opening, narrow_mm, wide_mm);
}

}  // namespace pizarra
