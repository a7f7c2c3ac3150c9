#pragma once

// The shape of a body of the simulated world on its own axes: a box, as cubes are, or an upright cylinder.
//
//   const BodyShape brick{.size_mm = {40, 80, 30}};
//   const BodyShape can{.is_round = true, .size_mm = {50, 50, 70}};
//   const BodyShape cube = cube_shape(60);

#include <Eigen/Core>

namespace pizarra::simulation {

struct BodyShape {
  bool is_round = false;    // a cylinder
  Eigen::Vector3d size_mm;  // of a cylinder: its diameter twice, and its height
};

inline BodyShape cube_shape(double edge_mm) { return {.size_mm = Eigen::Vector3d::Constant(edge_mm)}; }

}  // namespace pizarra::simulation
