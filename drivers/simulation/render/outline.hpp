#pragma once

// A convex polygon in an image as the half-planes inside its edges: what an anti-aliased fill needs to know.
//
//   const Outline outline(points);                     // either way round
//   const Span inside = outline.span(y, 0.5);          // columns that lie at least half a pixel inside
//   const float cover = outline.coverage(x, y);        // 0..1, of the pixel at x, y

#include <Eigen/Core>
#include <vector>

namespace pizarra::simulation {

// Columns first..last; empty when last < first.
struct Span {
  int first;
  int last;
  bool empty() const { return last < first; }
};

struct Rect {
  int left = 0;
  int top = 0;
  int right = 0;  // first column and row beyond
  int bottom = 0;
  bool empty() const { return right <= left || bottom <= top; }
  Rect united(const Rect& other) const;
  Rect intersected(const Rect& other) const;
  Rect grown(int by) const { return {left - by, top - by, right + by, bottom + by}; }
  bool operator==(const Rect&) const = default;
};

class Outline {
 public:
  struct Edge {
    double a;  // signed distance inside: a x + b y + c, px
    double b;
    double c;
  };

  Outline() = default;
  explicit Outline(const std::vector<Eigen::Vector2d>& points);
  explicit Outline(std::vector<Edge> edges) : edges_(std::move(edges)) {}
  static Edge edge(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  // Cuts off the tips that acute corners would otherwise grow when the outline is widened.
  void bound(const std::vector<Eigen::Vector2d>& points);

  bool empty() const { return edges_.empty(); }
  Span span(int y, double inset_px) const;
  // Distance inside the nearest edge; negative outside.
  double distance(double x, double y) const;
  float coverage(double x, double y) const;
  // Whether all points lie outside one of its edges, or reach no deeper inside than that.
  bool excludes(const std::vector<Eigen::Vector2d>& points, double depth_px) const;

 private:
  std::vector<Edge> edges_;
};

// The pixels that the points may touch, one around included.
Rect rect_around(const std::vector<Eigen::Vector2d>& points);

}  // namespace pizarra::simulation
