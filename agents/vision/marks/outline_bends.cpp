#include "agents/vision/marks/outline_bends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace pizarra::vision {
namespace {

// In places of the outline: how far behind a bend the template's rounding ends, and how far on the border is looked at.
constexpr int rounding = 2;
constexpr int looked_at = 4;
// A place farther from the one before, in their usual distances, begins another border.
constexpr double gap = 2.5;

class ClosedBorder {
 public:
  explicit ClosedBorder(std::span<const OutlinePoint> points)
      : points_(points), size_(static_cast<int>(points.size())) {}

  std::vector<BendsAround> bends() const {
    std::vector<BendsAround> out(points_.size());
    for (int i = 0; i < size_; ++i) out[index(i)].curvature = curvature(i);
    for (const int side : {1, -1}) {
      std::optional<int> last;
      // Twice around, so that the first places have met the bend behind them too.
      for (int k = 0; k < 2 * size_; ++k) {
        const int i = side * k;
        if (points_[index(i)].from_bend == 0) last = i;
        if (!last) continue;
        BendsAround& here = out[index(i)];
        here.any = true;
        here.next[side > 0 ? 0 : 1] = {points_[index(*last)].at,
                                       way(*last - side * rounding, *last - side * looked_at)};
      }
    }
    return out;
  }

 private:
  std::size_t index(int i) const { return static_cast<std::size_t>((i % size_ + size_) % size_); }
  cv::Vec2d way(int from, int to) const { return points_[index(to)].at - points_[index(from)].at; }
  bool is_near_bend(int i) const {
    for (int k = -looked_at; k <= looked_at; ++k) {
      if (points_[index(i + k)].from_bend == 0) return true;
    }
    return false;
  }
  double curvature(int i) const {
    if (is_near_bend(i)) return 0;
    const cv::Vec2d before = way(i - rounding, i);
    const cv::Vec2d after = way(i, i + rounding);
    const double turn = std::atan2(before[0] * after[1] - before[1] * after[0], before.dot(after));
    const double length = (cv::norm(before) + cv::norm(after)) / 2;
    const cv::Vec2d along = before + after;
    const cv::Vec2d& out = points_[index(i)].out;
    const bool ground_is_left = along[0] * out[1] - along[1] * out[0] > 0;
    return length > 0 ? (ground_is_left ? -turn : turn) / length : 0;
  }
  const std::span<const OutlinePoint> points_;
  const int size_;
};

}  // namespace

std::vector<BendsAround> bends_around(std::span<const OutlinePoint> points) {
  double usual = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < points.size(); ++i) usual = std::min(usual, cv::norm(points[i].at - points[i - 1].at));
  std::vector<BendsAround> out;
  for (std::size_t begin = 0; begin < points.size();) {
    std::size_t end = begin + 1;
    while (end < points.size() && cv::norm(points[end].at - points[end - 1].at) < gap * usual) ++end;
    const std::vector<BendsAround> of_border = ClosedBorder(points.subspan(begin, end - begin)).bends();
    out.insert(out.end(), of_border.begin(), of_border.end());
    begin = end;
  }
  return out;
}

}  // namespace pizarra::vision
