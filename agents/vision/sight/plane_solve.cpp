#include "agents/vision/sight/plane_solve.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "agents/vision/marks/outline_point.hpp"

namespace pizarra::vision {
namespace {

constexpr int numbers = 10;
using Numbers = Eigen::Matrix<double, numbers, 1>;
using NumbersMatrix = Eigen::Matrix<double, numbers, numbers>;
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

PlaneGuess moved(const PlaneGuess& pose, const Numbers& change) {
  return {turned_by(change.segment<3>(3)) * pose.turn, pose.place + change.head<3>(), pose.form + change.segment<3>(6),
          pose.pull_px + change[9]};
}

// The normal matrix, the step's right side, and half the squared deviations.
struct Equations {
  NumbersMatrix normal = NumbersMatrix::Zero();
  Numbers right = Numbers::Zero();
  double misfit = 0;
};

// Where a point of the plane is by its form, mm, along the plane's axes.
Vector2d formed(const Vector2d& p, const Vector3d& form) {
  return {p.x() * (form.x() + form.y()) + p.y() * form.z(), p.y() * (form.x() - form.y()) + p.x() * form.z()};
}

Vector3d turned(const PlanePoint& point, const PlaneGuess& pose) {
  return pose.turn.leftCols<2>() * formed(point.plane, pose.form);
}

// From the camera that sees it.
Vector3d in_space(const PlanePoint& point, const PlaneGuess& pose, const Vector3d& turned) {
  return turned + pose.place - point.beside_mm * Vector3d::UnitX();
}

// How far a point is off, px, and how it goes with each number.
struct PointError {
  double off;
  Numbers by;
};

// Nothing where it lies behind the camera.
std::optional<PointError> error_of(const PlanePoint& point, const PlaneGuess& pose) {
  const Vector3d arm = turned(point, pose);
  const Vector3d at = in_space(point, pose, arm);
  if (!(at.z() > 0)) return std::nullopt;
  const Vector2d slope = at.head<2>() / at.z();
  const Vector3d by_place = Vector3d(point.normal.x(), point.normal.y(), -point.normal.dot(slope)) / at.z();
  const Vector2d in_plane = pose.turn.leftCols<2>().transpose() * by_place;
  const Vector2d& p = point.plane;
  PointError out;
  out.off = point.normal.dot(point.seen - slope) - point.pulled * pose.pull_px;
  out.by.head<3>() = by_place;
  out.by.segment<3>(3) = arm.cross(by_place);
  out.by[6] = p.dot(in_plane);
  out.by[7] = p.x() * in_plane.x() - p.y() * in_plane.y();
  out.by[8] = p.y() * in_plane.x() + p.x() * in_plane.y();
  out.by[9] = point.pulled;
  return out;
}

// Adds what was known of the form and of the pull before.
void add_known(Equations& to, const PlaneGuess& pose, const PlaneErrors& errors) {
  to.normal.diagonal().segment<3>(3).array() += 1 / (unknown_turn_rad * unknown_turn_rad);
  const Eigen::Vector4d spread(errors.size_spread, errors.stretch_spread, errors.stretch_spread, errors.pull_spread_px);
  const Eigen::Vector4d prior = spread.array().square().inverse();
  Eigen::Vector4d off;
  off << pose.form - Vector3d::UnitX(), pose.pull_px - errors.usual_pull_px;
  to.normal.diagonal().tail<4>() += prior;
  to.right.tail<4>() -= prior.cwiseProduct(off);
  to.misfit += prior.dot(off.cwiseAbs2()) / 2;
}

// Nothing where it lies behind the camera in part.
std::optional<Equations> equations_of(std::span<const PlanePoint> points, const PlaneGuess& pose,
                                      const PlaneErrors& errors) {
  Equations out;
  for (const PlanePoint& point : points) {
    const std::optional<PointError> error = error_of(point, pose);
    if (!error) return std::nullopt;
    const Numbers weighted = errors.weight * error->by;
    // The lower triangle, column by column.
    for (int column = 0; column < numbers; ++column) {
      for (int row = column; row < numbers; ++row) out.normal(row, column) += weighted[row] * error->by[column];
    }
    out.right += error->off * weighted;
    out.misfit += errors.weight * error->off * error->off / 2;
  }
  out.normal.triangularView<Eigen::StrictlyUpper>() = out.normal.transpose();
  add_known(out, pose, errors);
  return out;
}

// Neighbours on the border.
bool are_pulled_alike(const PlanePoint& one, const PlanePoint& next) {
  return one.side == next.side && one.beside_mm == next.beside_mm && one.pulled == next.pulled;
}

// The covariance of an error that all pulled points of a side share.
NumbersMatrix shared_by_sides(std::span<const PlanePoint> points, const PlaneGuess& pose, const PlaneErrors& errors,
                              const NumbersMatrix& covariance) {
  NumbersMatrix out = NumbersMatrix::Zero();
  Numbers by_side = Numbers::Zero();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::optional<PointError> error = error_of(points[i], pose);
    if (error) by_side += errors.weight * points[i].pulled * error->by;
    if (i + 1 < points.size() && are_pulled_alike(points[i], points[i + 1])) continue;
    const Numbers moved_by_side = errors.side_spread_px * (covariance * by_side);
    out += moved_by_side * moved_by_side.transpose();
    by_side.setZero();
  }
  return out;
}

std::optional<SolvedPlane> solved(std::span<const PlanePoint> points, PlaneGuess pose, const PlaneErrors& errors) {
  const std::optional<Equations> first = equations_of(points, pose, errors);
  if (!first) return std::nullopt;
  Equations now = *first;
  for (int step = 0; step < most_steps; ++step) {
    Numbers change = now.normal.ldlt().solve(now.right);
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
  NumbersMatrix covariance = now.normal.inverse();
  covariance += shared_by_sides(points, pose, errors, covariance);
  return SolvedPlane{pose, covariance.topLeftCorner<6, 6>(), now.misfit};
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
  for (PlaneGuess guess : guesses) {
    guess.pull_px = errors.usual_pull_px;
    const std::optional<SolvedPlane> one = solved(points, guess, errors);
    if (one) out.push_back(*one);
  }
  std::ranges::sort(out, {}, &SolvedPlane::misfit);
  return out;
}

std::vector<PlaneMove> moves_without_sides(std::span<const PlanePoint> points, const PlaneGuess& pose,
                                           const PlaneErrors& errors) {
  // The place, the turn and the size: what else there is of the form is known too well to matter.
  constexpr int moved_numbers = 7;
  using Moved = Eigen::Matrix<double, moved_numbers, 1>;
  struct Side {
    Eigen::Matrix<double, moved_numbers, moved_numbers> normal = decltype(normal)::Zero();
    Moved right = Moved::Zero();
  };
  std::vector<Side> sides;
  for (const PlanePoint& point : points) {
    const std::optional<PointError> error = error_of(point, pose);
    if (!error) return {};
    const Moved by = error->by.head<moved_numbers>();
    if (point.side == OutlinePoint::no_side) continue;
    if (point.side >= sides.size()) sides.resize(point.side + 1);
    Side& side = sides[point.side];
    side.normal.noalias() += errors.weight * by * by.transpose();
    side.right += errors.weight * error->off * by;
  }
  Equations known;
  add_known(known, pose, errors);
  Side all{known.normal.topLeftCorner<moved_numbers, moved_numbers>(), known.right.head<moved_numbers>()};
  for (const Side& side : sides) {
    all.normal += side.normal;
    all.right += side.right;
  }
  std::vector<PlaneMove> out;
  out.reserve(sides.size());
  for (const Side& side : sides) {
    const Eigen::LLT<decltype(side.normal)> rest(all.normal - side.normal);
    Eigen::Matrix<double, moved_numbers, 4> of_place = decltype(of_place)::Identity();
    of_place.col(3) = all.right - side.right;
    rest.solveInPlace(of_place);
    out.push_back({of_place.topRightCorner<3, 1>(), of_place.topLeftCorner<3, 3>()});
  }
  return out;
}

double off_px(const PlanePoint& point, const PlaneGuess& pose) {
  const Vector3d at = in_space(point, pose, turned(point, pose));
  return point.normal.dot(point.seen - at.head<2>() / at.z()) - point.pulled * pose.pull_px;
}

cv::Matx33d matx_of(const Matrix3d& turn) {
  cv::Matx33d out;
  for (int i = 0; i < 9; ++i) out.val[i] = turn(i / 3, i % 3);
  return out;
}

}  // namespace pizarra::vision
