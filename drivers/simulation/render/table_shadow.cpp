#include "drivers/simulation/render/table_shadow.hpp"

#include <algorithm>

#include "drivers/simulation/render/convex.hpp"

namespace pizarra::simulation {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

Points lying_on_table(const Polygon& polygon) {
  Points out;
  for (const Vector2d& point : polygon) out.emplace_back(point.x(), point.y(), 0);
  return out;
}

}  // namespace

void add_shadow(std::vector<Points>& shadows, const Solid& solid, const TableConfig& table) {
  const Vector3d light = (lamp() + Vector3d(0, 0, 1.2)).normalized();
  std::vector<Vector2d> points;
  for (const Vector3d& vertex : solid.vertices) {
    const double height = std::max(0.0, vertex.z());
    const Vector2d on = vertex.head<2>() - light.head<2>() * (height / light.z());
    points.emplace_back(std::clamp(on.x(), table.x_low_mm, table.x_high_mm),
                        std::clamp(on.y(), table.y_low_mm, table.y_high_mm));
  }
  Points hull = lying_on_table(convex_hull(std::move(points)));
  if (hull.size() > 2) shadows.push_back(std::move(hull));
}

}  // namespace pizarra::simulation
