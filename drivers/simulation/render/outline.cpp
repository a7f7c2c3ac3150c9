#include "drivers/simulation/render/outline.hpp"

#include <algorithm>
#include <cmath>

namespace pizarra::simulation {

namespace {

constexpr double far_px = 1e6;

int to_column(double x) { return static_cast<int>(std::clamp(x, -far_px, far_px)); }

}  // namespace

Rect Rect::united(const Rect& other) const {
  if (empty()) return other;
  if (other.empty()) return *this;
  return {std::min(left, other.left), std::min(top, other.top), std::max(right, other.right),
          std::max(bottom, other.bottom)};
}

Rect Rect::intersected(const Rect& other) const {
  return {std::max(left, other.left), std::max(top, other.top), std::min(right, other.right),
          std::min(bottom, other.bottom)};
}

Outline::Edge Outline::edge(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  const Eigen::Vector2d along = (to - from).normalized();
  return {-along.y(), along.x(), along.y() * from.x() - along.x() * from.y()};
}

void Outline::bound(const std::vector<Eigen::Vector2d>& points) {
  if (points.empty() || edges_.empty()) return;
  Eigen::Vector2d low = points[0];
  Eigen::Vector2d high = points[0];
  for (const Eigen::Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  edges_.insert(edges_.end(), {{1, 0, -low.x()}, {-1, 0, high.x()}, {0, 1, -low.y()}, {0, -1, high.y()}});
}

Outline::Outline(const std::vector<Eigen::Vector2d>& points) {
  double twice_area = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d& p = points[i];
    const Eigen::Vector2d& q = points[(i + 1) % points.size()];
    twice_area += p.x() * q.y() - q.x() * p.y();
  }
  // Seen edge on it covers nothing.
  if (std::abs(twice_area) < 1e-3) return;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::Vector2d& p = points[i];
    const Eigen::Vector2d& q = points[(i + 1) % points.size()];
    if ((p - q).squaredNorm() < 1e-12) continue;
    edges_.push_back(twice_area > 0 ? edge(p, q) : edge(q, p));
  }
  if (points.size() < 8) bound(points);
}

Span Outline::span(int y, double inset_px) const {
  double low = -far_px;
  double high = far_px;
  for (const Edge& edge : edges_) {
    const double at_zero = edge.b * y + edge.c - inset_px;
    if (std::abs(edge.a) < 1e-12) {
      if (at_zero < 0) return {0, -1};
    } else if (edge.a > 0) {
      low = std::max(low, -at_zero / edge.a);
    } else {
      high = std::min(high, -at_zero / edge.a);
    }
  }
  if (edges_.empty() || low > high) return {0, -1};
  return {to_column(std::ceil(low)), to_column(std::floor(high))};
}

double Outline::distance(double x, double y) const {
  double nearest = far_px;
  for (const Edge& edge : edges_) nearest = std::min(nearest, edge.a * x + edge.b * y + edge.c);
  return nearest;
}

bool Outline::excludes(const std::vector<Eigen::Vector2d>& points, double depth_px) const {
  return std::ranges::any_of(edges_, [&](const Edge& edge) {
    return std::ranges::all_of(points, [&](const Eigen::Vector2d& point) {
      return edge.a * point.x() + edge.b * point.y() + edge.c <= depth_px;
    });
  });
}

float Outline::coverage(double x, double y) const {
  return static_cast<float>(std::clamp(0.5 + distance(x, y), 0.0, 1.0));
}

Rect rect_around(const std::vector<Eigen::Vector2d>& points) {
  if (points.empty()) return {};
  Eigen::Vector2d low = points[0];
  Eigen::Vector2d high = points[0];
  for (const Eigen::Vector2d& point : points) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  return {to_column(std::floor(low.x())) - 1, to_column(std::floor(low.y())) - 1, to_column(std::ceil(high.x())) + 2,
          to_column(std::ceil(high.y())) + 2};
}

}  // namespace pizarra::simulation
