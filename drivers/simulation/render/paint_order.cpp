#include "drivers/simulation/render/paint_order.hpp"

#include <algorithm>

namespace pizarra::simulation {

namespace {

using Eigen::Vector3d;

arm::Range along(const Solid& solid, const Vector3d& axis) {
  arm::Range range{1e12, -1e12};
  for (const Vector3d& vertex : solid.vertices) {
    const double at = axis.dot(vertex);
    range = {std::min(range.low, at), std::max(range.high, at)};
  }
  return range;
}

// The widest gap between two solids found so far, and which side of it the eye is on.
struct Gap {
  double width = -1e12;
  bool eye_with_first = false;

  void try_axis(const Solid& a, const Solid& b, const Vector3d& axis, const Vector3d& eye) {
    const arm::Range ra = along(a, axis);
    const arm::Range rb = along(b, axis);
    const double at = axis.dot(eye);
    if (rb.low - ra.high > width) {
      width = rb.low - ra.high;
      eye_with_first = at < (rb.low + ra.high) / 2;
    }
    if (ra.low - rb.high > width) {
      width = ra.low - rb.high;
      eye_with_first = at > (ra.low + rb.high) / 2;
    }
  }
};

Vector3d edge_of(const Solid& box, std::size_t which) {
  constexpr std::size_t ends[3] = {1, 2, 4};
  return box.vertices[ends[which]] - box.vertices[0];
}

// Whether `a` may hide `b`, rather than the reverse.
bool before(const Solid& a, const Solid& b, const Vector3d& eye) {
  Gap gap;
  for (const Face& face : a.faces) gap.try_axis(a, b, face.normal, eye);
  for (const Face& face : b.faces) gap.try_axis(a, b, face.normal, eye);
  const bool boxes = a.vertices.size() == 8 && b.vertices.size() == 8 && a.faces.size() == 6 && b.faces.size() == 6;
  if (gap.width < 0 && boxes) {
    for (std::size_t i = 0; i < 9; ++i) {
      const Vector3d axis = edge_of(a, i / 3).cross(edge_of(b, i % 3));
      if (axis.norm() > 1e-3) gap.try_axis(a, b, axis.normalized(), eye);
    }
  }
  return gap.eye_with_first;
}

// A hint of an overlap, far below what a pixel shows, is none.
constexpr double least_overlap_px = 1e-3;

bool meet(const SeenSolid& a, const SeenSolid& b) {
  if (a.rect.intersected(b.rect).empty()) return false;
  return !a.silhouette.excludes(b.corners, least_overlap_px) && !b.silhouette.excludes(a.corners, least_overlap_px);
}

}  // namespace

std::vector<std::size_t> paint_order(const Eye& eye, const std::vector<Solid>& solids,
                                     const std::vector<SeenSolid>& seen) {
  // behind[i]: what must be painted before i.
  const std::size_t count = solids.size();
  std::vector<std::vector<std::size_t>> behind(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = i + 1; j < count; ++j) {
      if (!meet(seen[i], seen[j])) continue;
      const bool first = before(solids[i], solids[j], eye.position_mm);
      behind[first ? i : j].push_back(first ? j : i);
    }
  }
  std::vector<std::size_t> order;
  std::vector<char> state(count, 0);
  // Depth first: whatever lies behind a solid is painted before it. A ring is cut where it closes.
  const auto visit = [&](const auto& self, std::size_t solid) -> void {
    if (state[solid] != 0) return;
    state[solid] = 1;
    for (const std::size_t other : behind[solid]) self(self, other);
    order.push_back(solid);
  };
  for (std::size_t i = 0; i < count; ++i) visit(visit, i);
  std::erase_if(order, [&](std::size_t solid) { return seen[solid].rect.empty(); });
  return order;
}

}  // namespace pizarra::simulation
