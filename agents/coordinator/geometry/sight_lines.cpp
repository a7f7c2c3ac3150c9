#include "agents/coordinator/geometry/sight_lines.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace pizarra::coordinator {

namespace {

using Eigen::Vector3d;

// Whether the line between the points passes through the box: it is inside of all three pairs of faces at once.
bool meets(const Eigen::AlignedBox3d& box, const Vector3d& from, const Vector3d& to) {
  const Vector3d along = to - from;
  double enters = 0;
  double leaves = 1;
  for (int axis = 0; axis < 3; ++axis) {
    // A line along the faces divides by zero: it is between them always, or never.
    const double low = (box.min()[axis] - from[axis]) / along[axis];
    const double high = (box.max()[axis] - from[axis]) / along[axis];
    enters = std::max(enters, std::min(low, high));
    leaves = std::min(leaves, std::max(low, high));
  }
  return enters < leaves;
}

}  // namespace

bool SightLines::covers(const Vector3d& nearer, const Vector3d& other) const {
  const double half = cube_mm / 2;
  if (nearer.x() - other.x() < half) return false;
  const Vector3d reach(half, half + margin_mm, half + margin_mm);
  const Eigen::AlignedBox3d box(nearer - reach, nearer + reach);
  for (const Vector3d& eye : eyes_mm) {
    for (const double aside : {-mark_half_mm, mark_half_mm}) {
      for (const double up : {-mark_half_mm, mark_half_mm}) {
        if (meets(box, other + Vector3d(half, aside, up), eye)) return true;
      }
    }
  }
  return false;
}

}  // namespace pizarra::coordinator
