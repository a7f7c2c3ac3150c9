#pragma once

// A cube that lies half beyond the border of the images is not recognised, though the arm may reach it. Sweeps over the
// table beside the images, from outside towards the middle, push it to where all of it shows. Before the lower border
// they pull it towards the arm. Where the arm comes to no place beyond it there, the open fingers go down around it and
// lift it.
//
//   for (const Push& sweep : border_sweeps(room, row_x_mm, {lost_mm, within_mm}, standing)) ...

#include <vector>

#include "agents/coordinator/geometry/elbow_room.hpp"

namespace pizarra::coordinator {

struct LostCube {
  Eigen::Vector3d seen_mm;  // its centre, where it was seen last
  double within_mm = 0;     // how far from there it may have come to lie
};

// The likeliest first. None where it may not have come so far, and none that meets what stands: the centres of the
// other cubes. `row_x_mm`: of the middle of the strips beside the images, which lie on either side of it and on it. The
// room says what is shown.
std::vector<Push> border_sweeps(const ElbowRoom& room, double row_x_mm, const LostCube& lost,
                                const std::vector<Eigen::Vector3d>& standing);

}  // namespace pizarra::coordinator
