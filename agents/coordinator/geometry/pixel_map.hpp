#pragma once

// How the gripper's mark goes over the left image when the arm moves, by the looks at it and nothing else: nobody knows
// where the camera stands. Near the places where it was seen its pixel is taken to be an affine function of the tool's
// place.
//
//   const std::optional<PixelMap> map = PixelMap::from(watch.pairs());
//   place += map->way_for(wanted_px - seen_px);       // Err_X and Err_Y; the tool moves along the base's y and z

#include <optional>
#include <span>

#include "agents/coordinator/geometry/camera_pose.hpp"

namespace pizarra::coordinator {

class PixelMap {
 public:
  // None where the places do not tell: fewer than four, or all in one plane.
  static std::optional<PixelMap> from(std::span<const MarkPair> pairs);

  // The way of the tool that takes the mark so far over the image, mm.
  Eigen::Vector3d way_for(const Eigen::Vector2d& error_px) const;

 private:
  explicit PixelMap(Eigen::Matrix<double, 2, 3> px_per_mm) : px_per_mm_(std::move(px_per_mm)) {}
  Eigen::Matrix<double, 2, 3> px_per_mm_;
};

}  // namespace pizarra::coordinator
