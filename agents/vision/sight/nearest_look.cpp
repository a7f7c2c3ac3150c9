#include "agents/vision/sight/nearest_look.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "agents/vision/sight/covered_part.hpp"

namespace pizarra::vision {
namespace {

// Noise makes less.
constexpr double least_farther_px = 0.5;
// How far all sides must have turned: a covered one's are known to 2 degrees.
constexpr double turned_rad = 0.14;

// In the image, of each side; the middle of a side says it best.
std::vector<double> directions_of(const PlaneOutline& outline, const PlaneFit& fit) {
  std::map<std::size_t, const OutlinePoint*> middles;
  for (const OutlinePoint& point : outline.points) {
    if (point.side == OutlinePoint::no_side) continue;
    const OutlinePoint*& middle = middles[point.side];
    if (middle == nullptr || middle->from_bend < point.from_bend) middle = &point;
  }
  std::vector<double> out;
  for (const auto& [side, middle] : middles) {
    const cv::Vec2d along = fit.slope_at(middle->at) * cv::Vec2d(-middle->out[1], middle->out[0]);
    out.push_back(std::atan2(along[1], along[0]));
  }
  return out;
}

bool have_turned(const std::vector<double>& before, const std::vector<double>& now) {
  double least = std::numeric_limits<double>::infinity();
  double most = -least;
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double turn = std::remainder(now[i] - before[i], 2 * std::numbers::pi);
    least = std::min(least, turn);
    most = std::max(most, turn);
  }
  return least > turned_rad || most < -turned_rad;
}

}  // namespace

double NearestLook::off_if_covered_px(const PlaneOutline& outline, const PlaneFit& fit, double range_mm, bool goes_on) {
  nearest_mm_ = std::min(nearest_mm_.value_or(range_mm), range_mm);
  const double off_px = triangle_reach * fit.size_px() * (range_mm / *nearest_mm_ - 1);
  std::vector<double> now = directions_of(outline, fit);
  if (off_px < least_farther_px || !goes_on || directions_.size() != now.size()) {
    directions_ = std::move(now);
    return off_px;
  }
  if (!have_turned(directions_, now)) return off_px;
  nearest_mm_ = range_mm;
  return 0;
}

}  // namespace pizarra::vision
