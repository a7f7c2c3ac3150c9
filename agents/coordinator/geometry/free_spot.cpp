#include "agents/coordinator/geometry/free_spot.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pizarra::coordinator {

namespace {

std::optional<Eigen::Vector2d> free_spot_at(double x_mm, const TableArea& area,
                                            const std::vector<Eigen::Vector2d>& occupied, double from_y_mm,
                                            const Shown& shown) {
  std::optional<Eigen::Vector2d> nearest;
  std::optional<Eigen::Vector2d> roomiest;
  double best_distance = std::numeric_limits<double>::infinity();
  double best_room = area.least_mm;
  for (double y = area.y_low_mm; y <= area.y_high_mm; y += area.grid_mm) {
    const Eigen::Vector2d spot(x_mm, y);
    if (spot.norm() < area.reach_low_mm || spot.norm() > area.reach_high_mm || (shown && !shown(spot))) continue;
    double room = std::numeric_limits<double>::infinity();
    bool hidden = false;
    for (const Eigen::Vector2d& other : occupied) {
      const double aside = std::abs(other.y() - y);
      if (std::abs(other.x() - x_mm) < area.depth_mm) {
        room = std::min(room, aside);
      } else {
        hidden = hidden || aside < area.unhidden_mm;
      }
    }
    if (hidden) continue;
    const double distance = std::abs(y - from_y_mm);
    if (room >= area.comfortable_mm && distance < best_distance) {
      best_distance = distance;
      nearest = spot;
    }
    if (room >= best_room) {
      best_room = room + 1e-9;
      roomiest = spot;
    }
  }
  return nearest ? nearest : roomiest;
}

}  // namespace

std::vector<Eigen::Vector3d> standing(std::vector<Eigen::Vector3d> centres, const std::optional<Eigen::Vector3d>& grip,
                                      double cube_mm) {
  const auto hangs = [&](const Eigen::Vector3d& centre) { return grip && (centre - *grip).norm() < cube_mm; };
  std::erase_if(centres, hangs);
  return centres;
}

std::optional<Eigen::Vector2d> free_spot(const TableArea& area, const std::vector<Eigen::Vector2d>& occupied,
                                         double from_y_mm, const Shown& shown) {
  for (double aside = 0; aside <= area.aside_mm; aside += area.grid_mm) {
    for (const double x_mm : {area.x_mm - aside, area.x_mm + aside}) {
      std::optional<Eigen::Vector2d> spot = free_spot_at(x_mm, area, occupied, from_y_mm, shown);
      if (spot) return spot;
    }
  }
  return std::nullopt;
}

double opening_between(const Eigen::Vector3d& centre, const std::vector<Eigen::Vector3d>& neighbours, double cube_mm,
                       double finger_mm, double narrow_mm, double wide_mm) {
  constexpr double margin_mm = 4;
  double opening = wide_mm;
  for (const Eigen::Vector3d& other : neighbours) {
    const Eigen::Vector3d apart = (other - centre).cwiseAbs();
    // Cubes that stand behind, before or well below cannot meet the fingers.
    const bool beside = apart.x() < 0.75 * cube_mm && other.z() > centre.z() - 0.75 * cube_mm;
    if (!beside || apart.y() < cube_mm / 2) continue;
    opening = std::min(opening, 2 * (apart.y() - cube_mm / 2 - finger_mm - margin_mm));
  }
  return std::clamp(opening, narrow_mm, wide_mm);
}

}  // namespace pizarra::coordinator
