#include "agents/vision/sight/plane_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "agents/vision/sight/plane_solve.hpp"

namespace pizarra::vision {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Eigen::Vector2d;

// Of an edge, px: what the pixels' phase, the lens and the template leave.
constexpr double least_edge_spread = 0.08;
// Neighbouring edges share pixels: so many are as good as one less.
constexpr double independent_share = 0.5;
// Of a stretch that is known by its amount, along either of two axes.
constexpr double one_of_two = 0.707;
constexpr double least_stretch = 0.001;
// By how much worse another explanation must be.
constexpr double clearly_worse = 4;
// With so much more misfit than any homography a pose is none.
constexpr double least_contradiction = 4;
constexpr double clearly_contradicted = 15;

std::vector<PlanePoint> edges_of(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& fit,
                                 double unit) {
  std::vector<PlanePoint> out;
  for (const PlaneEdge& edge : fit.edges) {
    if (!edge.counts || !edge.is_border) continue;
    const cv::Vec2d& p = outline.points[edge.point].at;
    out.push_back({Vector2d(p[0], p[1]) * unit,
                   {(edge.at.x - model.centre_x_px) / model.focal_px, (edge.at.y - model.centre_y_px) / model.focal_px},
                   Vector2d(edge.normal[0], edge.normal[1]) * model.focal_px});
  }
  return out;
}

// A look whose six numbers are those of an affine map.
double affine_misfit(const std::vector<PlanePoint>& edges, double weight) {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double squares = 0;
  for (const PlanePoint& edge : edges) {
    Vector6 j;
    j << edge.normal.x() * edge.plane, edge.normal.x(), edge.normal.y() * edge.plane, edge.normal.y();
    const double seen = edge.normal.dot(edge.seen);
    normal += weight * j * j.transpose();
    right += weight * j * seen;
    squares += weight * seen * seen;
  }
  return std::max(0.0, squares - right.dot(normal.ldlt().solve(right))) / 2;
}

double free_misfit(const PlaneFit& fit, double weight) {
  double squares = 0;
  for (const PlaneEdge& edge : fit.edges) {
    if (edge.counts && edge.is_border) squares += edge.off_px * edge.off_px;
  }
  return weight * squares / 2;
}

PlaneTilt tilt_of(const SolvedPlane& solved) {
  const Eigen::Vector3d& place = solved.pose.place;
  return {{place.x(), place.y(), place.z()}, matx_of(solved.pose.turn), solved.covariance, solved.misfit};
}

}  // namespace

bool PlanePose::is_contradicted() const { return misfit - free_misfit > clearly_contradicted; }

bool PlanePose::shows_perspective() const { return affine_misfit - misfit > clearly_worse; }

double PlanePose::share_of_other() const { return 1 / (1 + std::exp(std::min(other.misfit - misfit, 50.0))); }

std::optional<PlanePose> plane_pose(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& fit,
                                    const PlaneFace& face) {
  const double unit_mm = face.unit_mm;
  const std::vector<PlanePoint> edges = edges_of(model, outline, fit, unit_mm);
  if (edges.size() < 16) return std::nullopt;
  const double spread = std::max(least_edge_spread, fit.rms_px);
  const double weight = independent_share / (spread * spread);
  const std::vector<PlaneGuess> guesses = plane_guesses(model, fit.in_image({0, 0}), fit.slope() * (1 / unit_mm));
  const double stretch = (1 - face.slimness) / (1 + face.slimness);
  const PlaneErrors errors{.weight = weight, .stretch_spread = std::max(least_stretch, stretch * one_of_two)};
  const std::vector<SolvedPlane> both = solve_plane(edges, guesses, errors);
  if (both.empty()) return std::nullopt;
  PlanePose out{tilt_of(both.front()), tilt_of(both.back())};
  out.affine_misfit = affine_misfit(edges, weight);
  out.free_misfit = free_misfit(fit, weight);
  return out;
}

double covered_rather_than_tilted(const PlanePose& pose, double tilted_for_one_covered) {
  const double by_perspective =
      1 / (1 + tilted_for_one_covered * std::exp(std::clamp(pose.affine_misfit - pose.misfit, -50.0, 50.0)));
  // What is covered and tilted besides is neither.
  const double contradicted = pose.misfit - pose.free_misfit - least_contradiction;
  return contradicted > 0 ? std::max(by_perspective, 1 - std::exp(-contradicted)) : by_perspective;
}

double off_if_bent_px(const PlaneFit& fit) {
  double together = 0;
  double apart = 0;
  int count = 0;
  const PlaneEdge* before = nullptr;
  for (const PlaneEdge& edge : fit.edges) {
    const bool there = edge.counts && edge.is_border;
    if (there && before != nullptr) {
      together += edge.off_px * edge.off_px;
      apart += (edge.off_px - before->off_px) * (edge.off_px - before->off_px) / 2;
      ++count;
    }
    before = there ? &edge : nullptr;
  }
  if (count == 0) return 0;
  // Of a disc, which takes up most: measured of discs of which a straight edge hides up to a tenth.
  constexpr double moved_by_bent = 4;
  return moved_by_bent * std::sqrt(std::max(0.0, together - apart) / count);
}

}  // namespace pizarra::vision
