#include "drivers/simulation/render/convex.hpp"

#include <algorithm>

namespace pizarra::simulation {

namespace {

using Eigen::Vector2d;

// Above 0 where `b` lies to the left of the way from `o` to `a`.
double left_of_way(const Vector2d& o, const Vector2d& a, const Vector2d& b) {
  return (a.x() - o.x()) * (b.y() - o.y()) - (a.y() - o.y()) * (b.x() - o.x());
}

// The part to the left of the line through `from` and `to`.
Polygon left_of(const Polygon& polygon, const Vector2d& from, const Vector2d& to) {
  Polygon out;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2d& here = polygon[i];
    const Vector2d& next = polygon[(i + 1) % polygon.size()];
    const double inside = left_of_way(from, to, here);
    const double then = left_of_way(from, to, next);
    if (inside >= 0) out.push_back(here);
    if ((inside >= 0) != (then >= 0)) out.push_back(here + (next - here) * (inside / (inside - then)));
  }
  return out;
}

}  // namespace

// Andrew's monotone chain.
Polygon convex_hull(std::vector<Vector2d> points) {
  std::ranges::sort(points, {}, [](const Vector2d& p) { return std::pair(p.x(), p.y()); });
  Polygon hull;
  for (const int pass : {0, 1}) {
    const std::size_t start = hull.size();
    for (const Vector2d& point : points) {
      while (hull.size() >= start + 2 && left_of_way(hull[hull.size() - 2], hull.back(), point) <= 0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    if (pass == 0) std::ranges::reverse(points);
  }
  return hull;
}

Polygon part_within(const Polygon& border, Polygon polygon) {
  for (std::size_t i = 0; i < border.size() && !polygon.empty(); ++i) {
    polygon = left_of(polygon, border[i], border[(i + 1) % border.size()]);
  }
  return polygon;
}

}  // namespace pizarra::simulation
