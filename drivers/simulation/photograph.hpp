#pragma once

// Photographs that are seen in the world: kept in halves of halves, so that they are smooth from far away too.
//
//   const Photograph wall(image);                       // BGR
//   const Eigen::Vector3f colour = wall.at(120.5, 80, 3);
//   const LaidPhotograph laid{.print = print, .corner_mm = corner, .right_mm = right, .down_mm = down};

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "blackboard/stream.hpp"

namespace pizarra::simulation {

class Photograph {
 public:
  // Of three channels, and not empty.
  explicit Photograph(Image image);

  int width() const { return levels_.front().width; }
  int height() const { return levels_.front().height; }
  // Blue, green and red around a point `right` and `down` from its upper left corner, in its pixels; the mean of about
  // so many of them each way. Beyond its borders it goes on mirrored.
  Eigen::Vector3f at(double right, double down, double pixels) const;

 private:
  std::vector<Image> levels_;  // each half as large as the one before
};

// Flat in the base frame.
struct LaidPhotograph {
  std::shared_ptr<const Photograph> print;
  Eigen::Vector3d corner_mm;  // its upper left one
  Eigen::Vector3d right_mm;   // a pixel of it to the right
  Eigen::Vector3d down_mm;    // a pixel of it down
  float light = 1;            // how bright its white is
};

}  // namespace pizarra::simulation
