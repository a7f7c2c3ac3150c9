#pragma once

// The cells of a tag as one eye sees them, in perspective: how much of a pixel its light cells cover.
//
//   const SeenCells cells(eye, decal_cells);
//   const float light = cells.light(x, y);        // 0..1

#include "drivers/simulation/render/eye.hpp"
#include "drivers/simulation/render/solid.hpp"

namespace pizarra::simulation {

class SeenCells {
 public:
  SeenCells(const Eye& eye, const TagCells& cells);
  float light(int x, int y) const;

 private:
  bool is_light(double x, double y) const;

  std::shared_ptr<const TagPrint> print_;
  // From pixels to cells, both homogeneous.
  Eigen::Matrix3d to_cells_;
};

}  // namespace pizarra::simulation
