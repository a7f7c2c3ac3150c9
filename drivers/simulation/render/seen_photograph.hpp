#pragma once

// A photograph in the world as one eye sees it, in perspective.
//
//   const SeenPhotograph wall(eye, behind_the_table(config));
//   if (wall.is_ahead(x, y)) colour = wall.at(x, y);

#include "drivers/simulation/photograph.hpp"
#include "drivers/simulation/render/eye.hpp"

namespace pizarra::simulation {

class SeenPhotograph {
 public:
  SeenPhotograph(const Eye& eye, const LaidPhotograph& laid);
  // Whether the pixel looks at its plane at all.
  bool is_ahead(int x, int y) const;
  Eigen::Vector3f at(int x, int y) const;

 private:
  std::shared_ptr<const Photograph> print_;
  float light_;
  // From the eye's pixels to the photograph's, both homogeneous.
  Eigen::Matrix3d to_print_;
};

// Upright, as far behind the table as any part of it is seen, and as large as the eyes see there.
LaidPhotograph behind_the_table(const WorldConfig& config);
// Over all of the table, its upper border away from a camera that looks along -x.
LaidPhotograph over_the_table(const WorldConfig& config);

}  // namespace pizarra::simulation
