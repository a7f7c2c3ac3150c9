#pragma once

// The edges of an image as chains of places, each with the way to its lighter side; and where edges are, by their
// direction, so that it is known at once how much of an outline an image may show.
//
//   const EdgeChains edges = edge_chains(cut);
//   edges.is_edge({x, y}, towards_light)          // within two pixels, turned by less than some 30 degrees

#include <cstdint>
#include <vector>

#include "agents/vision/image/look.hpp"

namespace pizarra::vision {

struct EdgePlace {
  cv::Point2f at;   // px
  cv::Vec2f light;  // a unit vector
};
using EdgeChain = std::vector<EdgePlace>;  // about a pixel apart

struct EdgeChains {
  static constexpr int directions = 16;
  std::vector<EdgeChain> chains;
  cv::Mat_<std::uint16_t> near;  // a bit for each direction

  static int direction_of(const cv::Vec2d& light);
  bool is_edge(const cv::Point2d& at, const cv::Vec2d& light) const;
  // The chains as far as they are there.
  EdgeChains within(const cv::Rect& area) const;
};

// `cut.pixels`, with what noise is left in them.
EdgeChains edge_chains(const ImageCut& cut);

}  // namespace pizarra::vision
