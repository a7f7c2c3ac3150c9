#pragma once

// Which cubes stand before the marks of others, for eyes that face the arm.
//
//   const SightLines lines{.eyes_mm = {{1330, -45, 200}, {1330, 45, 200}}};
//   lines.cross({450, -170, 30}, {289, -239, 30});   // true: the eyes look past -202 there
//
// All points are cubes' centres, base frame.

#include <Eigen/Core>
#include <vector>

namespace pizarra::coordinator {

struct SightLines {
  std::vector<Eigen::Vector3d> eyes_mm = {};  // where each image is taken from; none: nothing covers anything
  double cube_mm = 60;
  double mark_half_mm = 22;  // from a mark's middle to its edge
  double margin_mm = 3;

  // Whether the one nearer the camera covers some of the other's mark, for one of the eyes.
  bool covers(const Eigen::Vector3d& nearer, const Eigen::Vector3d& other) const;
  // Whether either of them covers some of the other's mark.
  bool cross(const Eigen::Vector3d& one, const Eigen::Vector3d& other) const {
    return covers(one, other) || covers(other, one);
  }
};

}  // namespace pizarra::coordinator
