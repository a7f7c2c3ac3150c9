#include "agents/coordinator/geometry/sight_lines.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::coordinator {

bool SightLines::covers(const Eigen::Vector3d& nearer, const Eigen::Vector3d& other) const {
  const double half = cube_mm / 2;
  if (nearer.x() - other.x() < half || nearer.z() < other.z() - 0.75 * cube_mm) return false;
  const double face_x = other.x() + half;
  for (const Eigen::Vector2d& eye : eyes_mm) {
    for (const double mark_edge : {other.y() - mark_half_mm, other.y() + mark_half_mm}) {
      for (const double x : {std::max(face_x, nearer.x() - half), nearer.x() + half}) {
        const double y = mark_edge + (x - face_x) / (eye.x() - face_x) * (eye.y() - mark_edge);
        if (std::abs(y - nearer.y()) < half + margin_mm) return true;
      }
    }
  }
  return false;
}

}  // namespace pizarra::coordinator
