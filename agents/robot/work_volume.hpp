#pragma once

// Where the grip centre may be: a box in the base frame, mm.

#include <Eigen/Core>

namespace pizarra::robot {

struct WorkVolume {
  Eigen::Vector3d low_mm;
  Eigen::Vector3d high_mm;
  bool holds(const Eigen::Vector3d& point_mm) const {
    return (point_mm.array() >= low_mm.array()).all() && (point_mm.array() <= high_mm.array()).all();
  }
};

}  // namespace pizarra::robot
