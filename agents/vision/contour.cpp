#include "agents/vision/contour.hpp"

#include <array>
#include <cstdlib>

namespace pizarra {
namespace {

// The eight neighbours in clockwise order (y down), from the left.
constexpr std::array<std::array<int, 2>, 8> around = {
    {{-1, 0}, {-1, -1}, {0, -1}, {1, -1}, {1, 0}, {1, 1}, {0, 1}, {-1, 1}}};

bool inside(const cv::Mat& mask, int x, int y) { return mask.ptr<std::uint8_t>(y)[x] != 0; }

bool at_edge(const cv::Mat& mask, cv::Point p) {
  return p.x <= 0 || p.y <= 0 || p.x >= mask.cols - 1 || p.y >= mask.rows - 1;
}

// Twice the enclosed area, positive when the contour runs clockwise in the image.
long signed_area(const MarkContour& contour) {
  long sum = 0;
  for (std::size_t i = 0; i < contour.size(); ++i) {
    const cv::Point a = contour[i];
    const cv::Point b = contour[(i + 1) % contour.size()];
    sum += static_cast<long>(a.x) * b.y - static_cast<long>(b.x) * a.y;
  }
  return sum;
}

}  // namespace

std::optional<MarkContour> follow_contour(const cv::Mat& mask, cv::Point start, std::size_t max_points) {
  MarkContour contour;
  cv::Point at = start;
  std::size_t outside_direction = 0;  // where, seen from `at`, the last outside pixel lies
  std::size_t first_step = around.size();
  while (true) {
    if (at_edge(mask, at) || contour.size() >= max_points) return std::nullopt;
    std::size_t step = around.size();
    for (std::size_t turn = 1; turn <= around.size(); ++turn) {
      const std::size_t direction = (outside_direction + turn) % around.size();
      if (inside(mask, at.x + around[direction][0], at.y + around[direction][1])) {
        step = direction;
        break;
      }
    }
    if (step == around.size()) return MarkContour{at};
    if (at == start && step == first_step) return contour;
    if (contour.empty()) first_step = step;
    contour.push_back(at);
    at += cv::Point(around[step][0], around[step][1]);
    // The neighbour looked at before the step was outside; from the new place it lies one or two turns further back.
    outside_direction = (step + (step % 2 == 0 ? 6 : 5)) % around.size();
  }
}

std::optional<MarkContour> contour_from_centre(const cv::Mat& mask, cv::Point centre, int reach_px,
                                               std::size_t max_points) {
  const cv::Rect area(0, 0, mask.cols, mask.rows);
  for (int radius = 0; radius <= reach_px; ++radius) {
    for (int dy = -radius; dy <= radius; ++dy) {
      const int stride = std::abs(dy) == radius ? 1 : 2 * radius;
      for (int dx = -radius; dx <= radius; dx += stride) {
        cv::Point p = centre + cv::Point(dx, dy);
        if (!area.contains(p) || !inside(mask, p.x, p.y)) continue;
        while (p.x > 0 && inside(mask, p.x - 1, p.y)) --p.x;
        std::optional<MarkContour> contour = follow_contour(mask, p, max_points);
        if (contour && contour->size() > 1 && signed_area(*contour) <= 0) return std::nullopt;
        return contour;
      }
    }
  }
  return std::nullopt;
}

}  // namespace pizarra
