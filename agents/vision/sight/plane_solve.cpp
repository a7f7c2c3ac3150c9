#include "agents/vision/sight/plane_solve.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

namespace pizarra::vision {
namespace {

using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int most_steps = 12;
// A step that makes it worse is made shorter.
constexpr int most_halvings = 5;
// By so little misfit no pose is told from another.
constexpr double least_gain = 1e-3;
// The spread of a turn that the points leave open, such as a circle's.
constexpr double unknown_turn_rad = 1.8;

Matrix3d turned_by(const Vector3d& rad) {
  const double angle = rad.norm();
  return angle < 1e-12 ? Matrix3d(Matrix3d::Identity()) : Eigen::AngleAxisd(angle, rad / angle).toRotationMatrix();
}

PlaneGuess moved(const PlaneGuess& pose, const Vector9& change) {
  return {turned_by(change.segment<3>(3)) * pose.turn, pose.place + change.head<3>(), pose.form + change.tail<3>()};
}

// The normal matrix, the step's right side, and half the squared deviations.
struct Equations {
  Matrix9 normal = Matrix9::Zero();
  Vector9 right = Vector9::Zero();
  double misfit = 0;
};

// How a point of the plane goes with each number of the form.
Eigen::Matrix<double, 2, 3> by_form(const Vector2d& p) {
  Eigen::Matrix<double, 2, 3> out;
  out << p.x(), p.x(), p.y(), p.y(), -p.y(), p.x();
  return out;
}

Vector3d turned(const PlanePoint& point, const PlaneGuess& pose) {
  return pose.turn.leftCols<2>() * (by_form(point.plane) * pose.form);
}

// From the camera that sees it.
Vector3d in_space(const PlanePoint& point, const PlaneGuess& pose) {
  return turned(point, pose) + pose.place - point.beside_mm * Vector3d::UnitX();
}

// Nothing where it lies behind the camera in part.
std::optional<Equations> equations_of(std::span<const PlanePoint> points, const PlaneGuess& pose,
                                      const PlaneErrors& errors) {
  Equations out;
  for (const PlanePoint& point : points) {
    const Vector3d at = in_space(point, pose);
    if (!(at.z() > 0)) return std::nullopt;
    const Vector2d slope = at.head<2>() / at.z();
    const double off = point.normal.dot(point.seen - slope);
    const Vector3d by_place = Vector3d(point.normal.x(), point.normal.y(), -point.normal.dot(slope)) / at.z();
    const Vector2d in_plane = pose.turn.leftCols<2>().transpose() * by_place;
    Vector9 j;
    j << by_place, turned(point, pose).cross(by_place), by_form(point.plane).transpose() * in_plane;
    for (int row = 0; row < 9; ++row) {
      for (int column = 0; column <= row; ++column) out.normal(row, column) += errors.weight * j[row] * j[column];
    }
    out.right += errors.weight * off * j;
    out.misfit += errors.weight * off * off / 2;
  }
  out.normal.triangularView<Eigen::StrictlyUpper>() = out.normal.transpose();
  out.normal.diagonal().segment<3>(3).array() += 1 / (unknown_turn_rad * unknown_turn_rad);
  const Vector3d spread(errors.size_spread, errors.stretch_spread, errors.stretch_spread);
  const Vector3d prior = spread.array().square().inverse();
  const Vector3d off = pose.form - Vector3d::UnitX();
  out.normal.diagonal().tail<3>() += prior;
  out.right.tail<3>() -= prior.cwiseProduct(off);
  out.misfit += prior.dot(off.cwiseAbs2()) / 2;
  return out;
}

std::optional<SolvedPlane> solved(std::span<const PlanePoint> points, PlaneGuess pose, const PlaneErrors& errors) {
  const std::optional<Equations> first = equations_of(points, pose, errors);
  if (!first) return std::nullopt;
  Equations now = *first;
  for (int step = 0; step < most_steps; ++step) {
    Vector9 change = now.normal.ldlt().solve(now.right);
    if (!change.allFinite()) return std::nullopt;
    if (change.dot(now.right) < least_gain) break;
    std::optional<Equations> then;
    for (int halving = 0; halving < most_halvings && !then; ++halving, change /= 2) {
      const PlaneGuess tried = moved(pose, change);
      const std::optional<Equations> there = equations_of(points, tried, errors);
      if (!there || there->misfit > now.misfit) continue;
      pose = tried;
      then = there;
    }
    if (!then) break;
    now = *then;
  }
  return SolvedPlane{pose, now.normal.inverse().topLeftCorner<6, 6>(), now.misfit};
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
                                     const PlaneErrors& errors) {
  std::vector<SolvedPlane> out;
  for (const PlaneGuess& guess : guesses) {
    const std::optional<SolvedPlane> one = solved(points, guess, errors);
    if (one) out.push_back(*one);
  }
  std::ranges::sort(out, {}, &SolvedPlane::misfit);
  return out;
}

double off_px(const PlanePoint& point, const PlaneGuess& pose) {
  const Vector3d at = in_space(point, pose);
  return point.normal.dot(point.seen - at.head<2>() / at.z());
}

cv::Matx33d matx_of(const Matrix3d& turn) {
  cv::Matx33d out;
  for (int i = 0; i < 9; ++i) out.val[i] = turn(i / 3, i % 3);
  return out;
}

}  // namespace pizarra::vision
