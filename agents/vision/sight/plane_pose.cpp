#include "agents/vision/sight/plane_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

namespace pizarra::vision {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int steps = 8;
// Of an edge, px: what the pixels' phase, the lens and the template leave.
constexpr double least_edge_spread = 0.08;
// Neighbouring edges share pixels: so many are as good as one less.
constexpr double independent_share = 0.5;
// The spread of a turn that the outline leaves open, such as a circle's.
constexpr double unknown_turn_rad = 1.8;
// By how much worse the other tilt must be.
constexpr double clearly_worse = 4;
// With so much more misfit than any homography a pose is none.
constexpr double least_contradiction = 4;
constexpr double clearly_contradicted = 15;

struct Edge {
  Vector2d plane;
  Vector2d seen;    // slopes off the axis
  Vector2d normal;  // px
};

struct Guess {
  Matrix3d turn;
  Vector3d place;
};

std::vector<Edge> edges_of(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& fit,
                           double unit) {
  std::vector<Edge> out;
  for (const PlaneEdge& edge : fit.edges) {
    if (!edge.counts || !edge.is_border) continue;
    const cv::Vec2d& p = outline.points[edge.point].at;
    out.push_back({Vector2d(p[0], p[1]) * unit,
                   {(edge.at.x - model.centre_x_px) / model.focal_px, (edge.at.y - model.centre_y_px) / model.focal_px},
                   Vector2d(edge.normal[0], edge.normal[1]) * model.focal_px});
  }
  return out;
}

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

Matrix3d turned_by(const Vector3d& rad) {
  const double angle = rad.norm();
  return angle < 1e-12 ? Matrix3d(Matrix3d::Identity()) : Eigen::AngleAxisd(angle, rad / angle).toRotationMatrix();
}

// The two poses of a look without perspective: along the line of sight the plane's axes are as long as they look, and
// what they lack to a unit is depth, towards either side.
std::vector<Guess> guesses(const camera::StereoModel& model, const PlaneFit& fit, double unit) {
  const cv::Point2d middle = fit.in_image({0, 0});
  const Vector3d sight((middle.x - model.centre_x_px) / model.focal_px, (middle.y - model.centre_y_px) / model.focal_px,
                       1);
  const Matrix3d to_sight = Eigen::Quaterniond::FromTwoVectors(sight, Vector3d::UnitZ()).toRotationMatrix();
  const cv::Matx22d slope = fit.slope();
  Eigen::Matrix2d look;
  look << slope(0, 0), slope(0, 1), slope(1, 0), slope(1, 1);
  look = to_sight.topLeftCorner<2, 2>() * look / (model.focal_px * sight.norm() * unit);
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(look);
  const double scale = svd.singularValues()[0];
  if (!(scale > 0)) return {};
  const Vector2d right = look.col(0) / scale;
  const Vector2d down = look.col(1) / scale;
  const double right_depth = std::sqrt(std::max(0.0, 1 - right.squaredNorm()));
  const double down_depth = std::sqrt(std::max(0.0, 1 - down.squaredNorm()));
  const double side = right.dot(down) > 0 ? -1 : 1;
  std::vector<Guess> out;
  for (const double towards : {1.0, -1.0}) {
    Matrix3d turn;
    turn.col(0) = Vector3d(right.x(), right.y(), towards * right_depth).normalized();
    const Vector3d second(down.x(), down.y(), towards * side * down_depth);
    turn.col(2) = turn.col(0).cross(second).normalized();
    turn.col(1) = turn.col(2).cross(turn.col(0));
    out.push_back({to_sight.transpose() * turn, to_sight.transpose() * Vector3d(0, 0, 1 / scale)});
  }
  return out;
}

// Half the squared deviations, the normal matrix and the step's right side.
struct Equations {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double misfit = 0;
};

Equations equations_of(const std::vector<Edge>& edges, const Guess& pose, double weight) {
  Equations out;
  for (const Edge& edge : edges) {
    const Vector3d turned = pose.turn.leftCols<2>() * edge.plane;
    const Vector3d at = turned + pose.place;
    const Vector2d slope = at.head<2>() / at.z();
    const double off = edge.normal.dot(edge.seen - slope);
    Eigen::Matrix<double, 1, 3> by_place;
    by_place << edge.normal.x() / at.z(), edge.normal.y() / at.z(), -edge.normal.dot(slope) / at.z();
    Eigen::Matrix<double, 1, 6> j;
    j << by_place, by_place * -cross_matrix(turned);
    out.normal += weight * j.transpose() * j;
    out.right += weight * j.transpose() * off;
    out.misfit += weight * off * off / 2;
  }
  out.normal.diagonal().tail<3>().array() += 1 / (unknown_turn_rad * unknown_turn_rad);
  return out;
}

struct Fitted {
  Guess pose;
  Equations at;
};

std::optional<Fitted> fitted(const std::vector<Edge>& edges, Guess pose, double weight) {
  for (int step = 0; step < steps; ++step) {
    const Equations equations = equations_of(edges, pose, weight);
    const Vector6 change = equations.normal.ldlt().solve(equations.right);
    if (!change.allFinite()) return std::nullopt;
    pose.place += change.head<3>();
    pose.turn = turned_by(change.tail<3>()) * pose.turn;
    if (!(pose.place.z() > 0)) return std::nullopt;
    if (change.head<3>().norm() < 1e-6 * pose.place.z() && change.tail<3>().norm() < 1e-6) break;
  }
  return Fitted{pose, equations_of(edges, pose, weight)};
}

// A look whose six numbers are those of an affine map.
double affine_misfit(const std::vector<Edge>& edges, double weight) {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double squares = 0;
  for (const Edge& edge : edges) {
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

}  // namespace

double PlanePose::tilt_rad() const {
  const cv::Vec3d away(turn(0, 2), turn(1, 2), turn(2, 2));
  return std::acos(std::clamp(away.dot(place_mm) / cv::norm(place_mm), -1.0, 1.0));
}

bool PlanePose::is_contradicted() const { return misfit - free_misfit > clearly_contradicted; }

bool PlanePose::shows_perspective() const { return affine_misfit - misfit > clearly_worse; }

bool PlanePose::is_ambiguous() const { return other_misfit - misfit < clearly_worse; }

std::optional<PlanePose> plane_pose(const camera::StereoModel& model, const PlaneOutline& outline, const PlaneFit& fit,
                                    double unit_mm) {
  const std::vector<Edge> edges = edges_of(model, outline, fit, unit_mm);
  if (edges.size() < 16) return std::nullopt;
  const double spread = std::max(least_edge_spread, fit.rms_px);
  const double weight = independent_share / (spread * spread);
  std::vector<Fitted> both;
  for (const Guess& guess : guesses(model, fit, unit_mm)) {
    std::optional<Fitted> one = fitted(edges, guess, weight);
    if (one) both.push_back(*one);
  }
  if (both.empty()) return std::nullopt;
  std::ranges::sort(both, {}, [](const Fitted& one) { return one.at.misfit; });
  const Guess& best = both.front().pose;
  PlanePose out;
  out.place_mm = {best.place.x(), best.place.y(), best.place.z()};
  for (int i = 0; i < 9; ++i) out.turn.val[i] = best.turn(i / 3, i % 3);
  out.covariance = both.front().at.normal.inverse();
  out.misfit = both.front().at.misfit;
  out.other_misfit = both.back().at.misfit;
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
