#include "agents/vision/sight/plane_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "agents/vision/sight/plane_solve.hpp"

namespace pizarra::vision {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Eigen::Vector2d;

// Of an edge, px, at least.
constexpr double least_edge_spread = 0.03;
// Neighbouring edges' errors correlate by at most this.
constexpr double most_in_common = 0.8;
// For weighing explanations against each other: the error, px, that averaging edges does not reduce (the pixels' phase,
// the lens, the template), and the part of the edges that count as independent.
constexpr double least_common_spread = 0.08;
constexpr double independent_share = 0.5;
// A homography has so many numbers; a pose fewer than so many edges say nothing of.
constexpr int free_numbers = 8;
constexpr std::size_t least_edges = 12;
// Of a mark's size that both images of a pair say anew, as a part of it.
constexpr double size_spread_of_pair = 0.01;
// Of a stretch that is known by its amount, along either of two axes.
constexpr double one_of_two = 0.707;
constexpr double least_stretch = 0.001;
// By how much worse another explanation must be.
constexpr double clearly_worse = 4;
// With so much more misfit than any homography a pose is none.
constexpr double least_contradiction = 4;
constexpr double clearly_contradicted = 15;
// How far faces are turned from the axis of a camera that looks at them: a standard deviation.
constexpr double usual_turn_rad = 0.5;
// A tilt that is less likely is none.
constexpr double least_share_of_other = 0.01;

std::vector<PlanePoint> edges_of(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& fit,
                                 double unit, double beside_mm) {
  std::vector<PlanePoint> out;
  for (const PlaneEdge& edge : fit.edges) {
    if (!edge.counts || !edge.is_border) continue;
    const cv::Vec2d p = outline.points[edge.point].at - outline.middle;
    out.push_back({Vector2d(p[0], p[1]) * unit,
                   {(edge.at.x - model.centre_x_px) / model.focal_px, (edge.at.y - model.centre_y_px) / model.focal_px},
                   Vector2d(edge.normal[0], edge.normal[1]) * model.focal_px,
                   beside_mm});
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

// How the edges scatter about the outline, wherever that lies.
struct Scatter {
  double squares = 0;  // px
  double beside = 0;   // each times its neighbour
  int edges = 0;
  int numbers = 0;  // that were fitted

  double variance() const {
    return std::max(least_edge_spread * least_edge_spread, squares / std::max(1, edges - numbers));
  }
  // The inverse variance of an edge, counted as if each were off by itself. The errors of neighbours
  // correlate, less with each edge between them (a process of first order). The fit took away some of that: for each
  // number as much as one edge's.
  double weight() const {
    const double in_common = (beside + numbers * variance()) / (edges * variance());
    const double rho = std::clamp(in_common, 0.0, most_in_common);
    return (1 - rho) / (1 + rho) / variance();
  }
  double weight_of_explanations() const {
    return independent_share / std::max(least_common_spread * least_common_spread, squares / edges);
  }
};

void count(const PlaneFit& fit, Scatter& scatter) {
  scatter.numbers += free_numbers;
  const PlaneEdge* before = nullptr;
  for (const PlaneEdge& edge : fit.edges) {
    const bool there = edge.counts && edge.is_border;
    if (there) scatter.squares += edge.off_px * edge.off_px;
    if (there && before != nullptr) scatter.beside += edge.off_px * before->off_px;
    scatter.edges += there ? 1 : 0;
    before = there ? &edge : nullptr;
  }
}

cv::Point2d in_image(const camera::StereoModel& model, const cv::Vec3d& place_mm) {
  return {model.centre_x_px + model.focal_px * place_mm[0] / place_mm[2],
          model.centre_y_px + model.focal_px * place_mm[1] / place_mm[2]};
}

// Half of the squared deviations, of the edges and of how cameras are aimed.
double unlikely(const PlaneTilt& tilt) {
  const double turned = std::acos(std::min(1.0, std::abs(tilt.turn(2, 2)))) / usual_turn_rad;
  return tilt.misfit + turned * turned / 2;
}

PlaneTilt tilt_of(const SolvedPlane& solved, double share_of_misfit) {
  const Eigen::Vector3d& place = solved.pose.place;
  return {
      {place.x(), place.y(), place.z()}, matx_of(solved.pose.turn), solved.covariance, share_of_misfit * solved.misfit};
}

}  // namespace

bool PlanePose::is_contradicted() const { return misfit - free_misfit > clearly_contradicted; }

bool PlanePose::shows_perspective() const { return affine_misfit - misfit > clearly_worse; }

double PlanePose::share_of_other() const { return 1 / (1 + std::exp(std::min(other.misfit - misfit, 50.0))); }

std::optional<PlanePose> plane_pose(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& left,
                                    const PlaneFace& face, const PlaneFit* right) {
  std::vector<PlanePoint> edges = edges_of(model, outline, left, face.unit_mm, 0);
  if (edges.size() < least_edges) return std::nullopt;
  Scatter scatter;
  count(left, scatter);
  PlaneErrors errors;
  if (right != nullptr) {
    count(*right, scatter);
    const std::vector<PlanePoint> in_right = edges_of(model, outline, *right, face.unit_mm, model.base_line_mm);
    edges.insert(edges.end(), in_right.begin(), in_right.end());
    errors.size_spread = size_spread_of_pair;
  }
  errors.weight = scatter.weight();
  const double stretch = (1 - face.slimness) / (1 + face.slimness);
  errors.stretch_spread = std::max(least_stretch, stretch * one_of_two);
  const cv::Matx22d slope = left.slope_at(outline.middle) * (1 / face.unit_mm);
  const std::vector<PlaneGuess> guesses = plane_guesses(model, left.in_image(outline.middle), slope);
  // Two images tell the tilts apart: the first guess most often ends at the right one.
  std::vector<SolvedPlane> both;
  if (right != nullptr)
    both = solve_plane(edges, std::span(guesses).first(std::min<std::size_t>(1, guesses.size())), errors);
  const bool is_explained = !both.empty() && both.front().misfit < static_cast<double>(edges.size());
  if (!is_explained) both = solve_plane(edges, guesses, errors);
  if (both.empty()) return std::nullopt;
  const double weight = scatter.weight_of_explanations();
  PlanePose out{tilt_of(both.front(), weight / errors.weight), tilt_of(both.back(), weight / errors.weight)};
  out.by_both = right != nullptr;
  if (!out.by_both) out.affine_misfit = affine_misfit(edges, weight);
  out.free_misfit = weight * scatter.squares / 2;
  return out;
}

cv::Point2d middle_in_image(const camera::StereoModel& model, const PlanePose& pose, double most_off_px) {
  const cv::Point2d told = in_image(model, pose.place_mm);
  const cv::Point2d other = in_image(model, pose.other.place_mm);
  const double of_other = 1 / (1 + std::exp(std::clamp(unlikely(pose.other) - unlikely(pose), -50.0, 50.0)));
  const double most = std::max(0.5, most_off_px / std::max(most_off_px, cv::norm(told - other)));
  const bool either = pose.share_of_other() > least_share_of_other;
  const double share = either ? std::clamp(of_other, 1 - most, most) : of_other;
  return (1 - share) * told + share * other;
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
