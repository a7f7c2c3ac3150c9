#pragma once

// The outline of a learned mark in its plane, to a fraction of a template's pixel: where its borders run, holes
// included, and where the ground lies from each place. Lengths are in standard deviations of the mark, from its
// centroid.
//
//   const PlaneOutline outline = plane_outline(sample.picture);
//   for (const PlaneOutline::Point& point : outline.points) point.at, point.out ...

#include <array>
#include <vector>

#include "agents/vision/image/contour.hpp"
#include "agents/vision/marks/mark_signature.hpp"
#include "agents/vision/marks/outline_bends.hpp"

namespace pizarra::vision {

// How far a closed line reaches from its middle, turn by turn, once its own second moments are made those of a circle:
// what two lines have in common that are views of one, but for how they are turned.
struct Reach {
  static constexpr int turns = 64;
  std::array<float, turns> values{};
  cv::Point2d middle;  // of the area enclosed
  cv::Matx22d spread;  // the symmetric root of its covariance

  double variation() const;  // of the values: a standard deviation
};
// Nothing where it encloses no area.
std::optional<Reach> reach_of(const std::vector<cv::Point2d>& closed);

// The root of the mean squared difference of both, and by how many turns the second is ahead of the first.
struct ReachFit {
  double error;
  int turn;
};
ReachFit fit_reach(const Reach& seen, const Reach& learned);
// The error at each turn.
std::array<double, Reach::turns> reach_errors(const Reach& seen, const Reach& learned);

struct PlaneOutline {
  static constexpr int count = 96;
  using Point = OutlinePoint;
  std::vector<Point> points;            // evenly along all borders
  std::vector<BendsAround> bends = {};  // of the points, in their order
  std::size_t outermost = 0;            // so many of them, the first ones, along the outermost border
  cv::Vec2d middle;  // of the area within them, which no light shifts as it may the centroid of the levels
  Reach reach;       // of the outermost border
  // Of the template's pixels those that are of the mark, or of the ground right beside it.
  std::array<bool, template_size * template_size> near{};
};

// Without points where the picture shows no closed border.
PlaneOutline plane_outline(const MarkTemplate& picture);

}  // namespace pizarra::vision
