#include "agents/vision/sight/plane_solve.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace pizarra::vision {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int most_steps = 12;
// A step that makes it worse is made shorter.
constexpr int most_halvings = 5;
// The spread of a turn that the points leave open, such as a circle's.
constexpr double unknown_turn_rad = 1.8;

Matrix3d cross_matrix(const Vector3d& v) {
  Matrix3d out;
  out << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return out;
}

Matrix3d turned_by(const Vector3d& rad) {
  const double angle = rad.norm();
  return angle < 1e-12 ? Matrix3d(Matrix3d::Identity()) : Eigen::AngleAxisd(angle, rad / angle).toRotationMatrix();
}

PlaneGuess moved(const PlaneGuess& pose, const Vector6& change) {
  return {turned_by(change.tail<3>()) * pose.turn, pose.place + change.head<3>()};
}

// The normal matrix, the step's right side, and half the squared deviations.
struct Equations {
  Matrix6 normal = Matrix6::Zero();
  Vector6 right = Vector6::Zero();
  double misfit = 0;
};

Equations equations_of(std::span<const PlanePoint> points, const PlaneGuess& pose, double weight) {
  Equations out;
  for (const PlanePoint& point : points) {
    const Vector3d turned = pose.turn.leftCols<2>() * point.plane;
    const Vector3d at = turned + pose.place;
    const Vector2d slope = at.head<2>() / at.z();
    const double off = point.normal.dot(point.seen - slope);
    Eigen::Matrix<double, 1, 3> by_place;
    by_place << point.normal.x() / at.z(), point.normal.y() / at.z(), -point.normal.dot(slope) / at.z();
    Eigen::Matrix<double, 1, 6> j;
    j << by_place, by_place * -cross_matrix(turned);
    out.normal += weight * j.transpose() * j;
    out.right += weight * j.transpose() * off;
    out.misfit += weight * off * off / 2;
  }
  out.normal.diagonal().tail<3>().array() += 1 / (unknown_turn_rad * unknown_turn_rad);
  return out;
}

bool lies_ahead(std::span<const PlanePoint> points, const PlaneGuess& pose) {
  return std::ranges::all_of(points, [&](const PlanePoint& point) {
    return pose.turn.row(2).head<2>().dot(point.plane) + pose.place.z() > 0;
  });
}

std::optional<SolvedPlane> solved(std::span<const PlanePoint> points, PlaneGuess pose, double weight) {
  if (!lies_ahead(points, pose)) return std::nullopt;
  Equations now = equations_of(points, pose, weight);
  for (int step = 0; step < most_steps; ++step) {
    Vector6 change = now.normal.ldlt().solve(now.right);
    if (!change.allFinite()) return std::nullopt;
    std::optional<Equations> then;
    for (int halving = 0; halving < most_halvings && !then; ++halving, change /= 2) {
      const PlaneGuess tried = moved(pose, change);
      if (!lies_ahead(points, tried)) continue;
      const Equations there = equations_of(points, tried, weight);
      if (there.misfit > now.misfit) continue;
      pose = tried;
      then = there;
    }
    if (!then) break;
    now = *then;
    if (change.head<3>().norm() < 1e-6 * pose.place.z() && change.tail<3>().norm() < 1e-6) break;
  }
  return SolvedPlane{pose, now.normal, now.misfit};
}

}  // namespace

std::vector<PlaneGuess> plane_guesses(const camera::StereoModel& model, cv::Point2d middle, const cv::Matx22d& slope) {
  const Vector3d sight((middle.x - model.centre_x_px) / model.focal_px, (middle.y - model.centre_y_px) / model.focal_px,
                       1);
  const Matrix3d to_sight = Eigen::Quaterniond::FromTwoVectors(sight, Vector3d::UnitZ()).toRotationMatrix();
  Eigen::Matrix2d look;
  look << slope(0, 0), slope(0, 1), slope(1, 0), slope(1, 1);
  look = to_sight.topLeftCorner<2, 2>() * look / (model.focal_px * sight.norm());
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(look);
  const double scale = svd.singularValues()[0];
  if (!(scale > 0)) return {};
  const Vector2d right = look.col(0) / scale;
  const Vector2d down = look.col(1) / scale;
  const double right_depth = std::sqrt(std::max(0.0, 1 - right.squaredNorm()));
  const double down_depth = std::sqrt(std::max(0.0, 1 - down.squaredNorm()));
  const double side = right.dot(down) > 0 ? -1 : 1;
  std::vector<PlaneGuess> out;
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

std::vector<SolvedPlane> solve_plane(std::span<const PlanePoint> points, std::span<const PlaneGuess> guesses,
                                     double weight) {
  std::vector<SolvedPlane> out;
  for (const PlaneGuess& guess : guesses) {
    const std::optional<SolvedPlane> one = solved(points, guess, weight);
    if (one) out.push_back(*one);
  }
  std::ranges::sort(out, {}, &SolvedPlane::misfit);
  return out;
}

double off_px(const PlanePoint& point, const PlaneGuess& pose) {
  const Vector3d at = pose.turn.leftCols<2>() * point.plane + pose.place;
  return point.normal.dot(point.seen - at.head<2>() / at.z());
}

cv::Matx33d matx_of(const Matrix3d& turn) {
  cv::Matx33d out;
  for (int i = 0; i < 9; ++i) out.val[i] = turn(i / 3, i % 3);
  return out;
}

}  // namespace pizarra::vision
