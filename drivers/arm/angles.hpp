#pragma once

// Turns by degrees, as everything but the mathematical library counts them.
//
//   const Eigen::Vector3d ahead = about_z(90) * Eigen::Vector3d::UnitX();     // along y

#include <Eigen/Geometry>

#include "lisp/numbers.hpp"

namespace pizarra::arm {

inline Eigen::Matrix3d about_y(double deg) {
  return Eigen::AngleAxisd(radians(deg), Eigen::Vector3d::UnitY()).toRotationMatrix();
}
inline Eigen::Matrix3d about_z(double deg) {
  return Eigen::AngleAxisd(radians(deg), Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace pizarra::arm
