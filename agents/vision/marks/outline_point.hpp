#pragma once

// A place on the border of a learned mark, in its plane: standard deviations of the mark, from its centroid.

#include <limits>
#include <opencv2/core.hpp>

namespace pizarra::vision {

struct OutlinePoint {
  cv::Vec2d at;
  cv::Vec2d out;         // a unit vector towards the ground
  double from_corner;    // along the border: from a sharp corner
  double from_bend;      // from any corner, the template's rounded ones too
  double depth;          // how far the ink reaches from there, straight inwards
  std::size_t side = 0;  // outline_sides.hpp
  static constexpr std::size_t no_side = std::numeric_limits<std::size_t>::max();
  // The template rounds the border so far on either side of a corner.
  static constexpr double rounded_reach = 0.25;
  bool is_rounded() const { return from_bend <= rounded_reach; }
};

}  // namespace pizarra::vision
