#include "agents/vision/marks/outline_sides.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::vision {
namespace {

// The cosine of how much the ways may differ that points of one side look, and how far they are from one line, in
// standard deviations of the mark.
constexpr double same_way = 0.95;
constexpr double same_line = 0.2;
// With fewer points it is the turn about a corner.
constexpr std::ptrdiff_t least_of_side = 3;

}  // namespace

// From the middle of each side on, where no corner turns the border.
void number_sides(std::vector<OutlinePoint>& points) {
  std::vector<OutlinePoint*> by_corners;
  for (OutlinePoint& point : points) by_corners.push_back(&point);
  std::ranges::stable_sort(by_corners, std::ranges::greater(), &OutlinePoint::from_bend);
  std::vector<const OutlinePoint*> middles;
  for (OutlinePoint* point : by_corners) {
    const auto side = std::ranges::find_if(middles, [&](const OutlinePoint* middle) {
      return middle->out.dot(point->out) > same_way && std::abs(middle->out.dot(point->at - middle->at)) < same_line;
    });
    point->side = static_cast<std::size_t>(side - middles.begin());
    if (side == middles.end()) middles.push_back(point);
  }
  std::vector<std::ptrdiff_t> lengths(middles.size());
  for (const OutlinePoint& point : points) ++lengths[point.side];
  for (OutlinePoint& point : points) {
    if (lengths[point.side] < least_of_side) point.side = OutlinePoint::no_side;
  }
}

}  // namespace pizarra::vision
