#pragma once

// Degrees, as everything but the mathematical library counts them.

#include <Eigen/Geometry>
#include <numbers>

namespace pizarra::arm {

inline double radians(double deg) { return deg * std::numbers::pi / 180; }
inline double degrees(double rad) { return rad * 180 / std::numbers::pi; }

inline Eigen::Matrix3d about_y(double deg) {
  return Eigen::AngleAxisd(radians(deg), Eigen::Vector3d::UnitY()).toRotationMatrix();
}
inline Eigen::Matrix3d about_z(double deg) {
  return Eigen::AngleAxisd(radians(deg), Eigen::Vector3d::UnitZ()).toRotationMatrix();
}

}  // namespace pizarra::arm
