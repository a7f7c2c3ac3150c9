#pragma once

// One pinhole camera of the pair: the base frame in, pixels out.
//
//   const Eye left = make_eye(config, Side::left);
//   const Eigen::Vector3d seen = left.project({480, 0, 30});   // x px, y px, depth mm

#include <Eigen/Geometry>

#include "drivers/simulation/world_config.hpp"

namespace pizarra::simulation {

enum class Side : std::uint8_t { left, right };

struct Eye {
  int width;
  int height;
  double focal_px;
  double centre_x_px;
  double centre_y_px;
  Eigen::Vector3d position_mm;
  // Rows: image right, image down, viewing direction; in the base frame.
  Eigen::Matrix3d axes;

  Eigen::Vector3d project(const Eigen::Vector3d& point_mm) const;
  // From a plane's own coordinates, counted from a corner in steps of two vectors, to pixels, both homogeneous; the
  // third pixel coordinate has the sign of the depth.
  Eigen::Matrix3d plane_to_pixels(const Eigen::Vector3d& corner_mm, const Eigen::Vector3d& right_mm,
                                  const Eigen::Vector3d& down_mm) const;
};

// The left camera is the one at the left of the image: half a base line away from the centre, against image right.
Eye make_eye(const CameraConfig& camera, Side side);

}  // namespace pizarra::simulation
