#pragma once

// Where an outline bends, as each place of it sees it: how the border goes on beyond the next bends, and how it curves.
//
//   const std::vector<BendsAround> bends = bends_around(outline.points);       // in their order

#include <array>
#include <span>
#include <vector>

#include "agents/vision/marks/outline_point.hpp"

namespace pizarra::vision {

struct Bend {
  cv::Vec2d at;
  cv::Vec2d beyond;  // along the border behind it, away from the place
};

struct BendsAround {
  bool any = false;          // a circle has none
  std::array<Bend, 2> next;  // to either side
  // Positive where the border bulges towards the ground; none is known beside a bend.
  double curvature = 0;
};

std::vector<BendsAround> bends_around(std::span<const OutlinePoint> points);

}  // namespace pizarra::vision
