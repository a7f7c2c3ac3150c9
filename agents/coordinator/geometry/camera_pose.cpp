#include "agents/coordinator/geometry/camera_pose.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "agents/coordinator/geometry/mark_fit.hpp"

namespace pizarra::coordinator {

namespace {

// x, y, z, pan, tilt, roll, mark
constexpr int unknowns = 9;
using Nine = Numbers<unknowns>;

// Marks whose depth is told by their size alone count as seen by a pair with so short a base line.
constexpr double least_base_line_mm = 10;
constexpr double least_depth_mm = 1;
// 99.99 % of what agrees with a fit lies within, of three coordinates.
constexpr double gate_deviations = 4.6;

Nine numbers_of(const MountedCamera& camera) {
  Nine numbers;
  numbers << camera.pose.at_mm[0], camera.pose.at_mm[1], camera.pose.at_mm[2], camera.pose.pan_deg,
      camera.pose.tilt_deg, camera.pose.roll_deg, camera.mark_mm;
  return numbers;
}

// `axes`: of the unit that it stands on, which moves with it.
MountedCamera camera_of(const Nine& n, const std::optional<forms::HeadAxes>& axes) {
  return {.pose = {.at_mm = {n[0], n[1], n[2]}, .pan_deg = n[3], .tilt_deg = n[4], .roll_deg = n[5], .axes = axes},
          .mark_mm = n.tail<3>()};
}

// By what numbers say of where the camera stands.
auto expected_by(const std::optional<forms::HeadAxes>& axes, const CameraModel& model) {
  return [&axes, &model](const Nine& numbers, const MarkPair& pair) {
    return expected_mark(camera_of(numbers, axes), pair, model);
  };
}

Nine deviations_of(const Sureness& sure) {
  Nine out;
  out << Eigen::Vector3d::Constant(sure.at_mm), Eigen::Vector3d::Constant(sure.turned_deg),
      Eigen::Vector3d::Constant(sure.mark_mm);
  return out;
}

}  // namespace

SeenMark seen_mark(const CameraView& view, const Eigen::Vector3d& point_mm) {
  // A pose that is tried on the way to the solution may look past the point.
  const Eigen::Vector3d ahead = view.to_camera(point_mm);
  const Sight sight = view.sight(view.from_camera({ahead.x(), ahead.y(), std::max(ahead.z(), least_depth_mm)}));
  return {sight.x_px, sight.y_px, view.focal_px() * std::max(view.base_line_mm(), least_base_line_mm) / sight.depth_mm};
}

Eigen::Isometry3d tool_pose(const Eigen::Vector3d& at_mm, double rx_deg, double ry_deg, double rz_deg) {
  constexpr double degree = std::numbers::pi / 180;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = (Eigen::AngleAxisd(rz_deg * degree, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(ry_deg * degree, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rx_deg * degree, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  pose.translation() = at_mm;
  return pose;
}

double deviation_px(const MarkPair& pair) {
  // Of one look; and what stays however often one looks from the same place.
  constexpr double look_px = 0.25;
  constexpr double lasting_px = 0.2;
  return std::hypot(look_px / std::sqrt(pair.looks), lasting_px);
}

Eigen::Vector3d eigenvalues_of(const Eigen::Matrix3d& symmetric) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  return solver.computeDirect(symmetric, Eigen::EigenvaluesOnly).eigenvalues();
}

SeenMark expected_mark(const MountedCamera& camera, const MarkPair& pair, const CameraModel& model) {
  return seen_mark(CameraView(camera.pose, model, pair.head), pair.tool * camera.mark_mm);
}

MountFit fit_mount(const MountedCamera& guess, const Sureness& sure, std::span<const MarkPair> pairs,
                   const CameraModel& model) {
  const MarkFit<unknowns> fit =
      fit_to_marks<unknowns>(numbers_of(guess), deviations_of(sure), pairs, expected_by(guess.pose.axes, model));
  return {.camera = camera_of(fit.numbers, guess.pose.axes), .covariance = fit.covariance, .error_px = fit.error_px};
}

namespace {

// Before the camera: across, down and ahead of its base line's centre.
Eigen::Vector3d before_camera(const SeenMark& seen, const CameraModel& model) {
  const double base_line_mm = std::max(model.base_line_mm, least_base_line_mm);
  const double depth = model.focal_px * base_line_mm / seen.z();
  return {(seen.x() - model.centre_x_px) * depth / model.focal_px - model.base_line_mm / 2,
          (seen.y() - model.centre_y_px) * depth / model.focal_px, depth};
}

// Of a camera whose images' axes these are, in the base frame.
forms::CameraPose pose_of_axes(const Eigen::Vector3d& at, const Eigen::Matrix3d& axes, HeadTurn head) {
  constexpr double degree = std::numbers::pi / 180;
  const Eigen::Vector3d across = axes.col(0);
  const Eigen::Vector3d forward = axes.col(2);
  const double pan = std::remainder(180 - std::atan2(forward.y(), forward.x()) / degree, 360);
  const double tilt = std::asin(std::clamp(forward.z(), -1.0, 1.0)) / degree;
  const Eigen::Vector3d level = forward.cross(Eigen::Vector3d::UnitZ()).normalized();
  const double roll = std::atan2(across.dot(forward.cross(level)), across.dot(level)) / degree;
  return {.at_mm = {at.x(), at.y(), at.z()},
          .pan_deg = pan - head.pan_deg,
          .tilt_deg = tilt - head.tilt_deg,
          .roll_deg = roll};
}

}  // namespace

// Horn's absolute orientation, as Eigen has it, of the marks as the camera sees them and as the arm says where they
// are.
std::optional<forms::CameraPose> pose_from_pairs(const Eigen::Vector3d& mark_mm, std::span<const MarkPair> pairs,
                                                 const CameraModel& model) {
  constexpr std::size_t least_pairs = 4;
  constexpr double least_way_mm = 40;  // along the second longest direction in which they lie apart
  if (pairs.size() < least_pairs) return std::nullopt;
  Eigen::Matrix3Xd seen(3, pairs.size());
  Eigen::Matrix3Xd said(3, pairs.size());
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const bool turned =
        pairs[i].head.pan_deg != pairs[0].head.pan_deg || pairs[i].head.tilt_deg != pairs[0].head.tilt_deg;
    if (turned || pairs[i].seen.z() <= 0) return std::nullopt;
    seen.col(static_cast<Eigen::Index>(i)) = before_camera(pairs[i].seen, model);
    said.col(static_cast<Eigen::Index>(i)) = pairs[i].tool * mark_mm;
  }
  const Eigen::Matrix3Xd apart = said.colwise() - said.rowwise().mean();
  const Eigen::Matrix3d scatter = apart * apart.transpose() / static_cast<double>(pairs.size());
  if (eigenvalues_of(scatter)[1] < least_way_mm * least_way_mm) return std::nullopt;
  const Eigen::Matrix4d pose = Eigen::umeyama(seen, said, false);
  return pose_of_axes(pose.topRightCorner<3, 1>(), pose.topLeftCorner<3, 3>(), pairs[0].head);
}

double MountFit::spread_mm(const Eigen::Vector3d& point_mm) const {
  const Eigen::Vector3d seen = CameraView(camera.pose, {}).to_camera(point_mm);
  const auto slope = slopes<unknowns>(numbers_of(camera), [&](const Nine& numbers) -> Eigen::Vector3d {
    return CameraView(camera_of(numbers, {}).pose, {}).from_camera(seen);
  });
  const Eigen::Matrix3d placed = slope * covariance * slope.transpose();
  // Rounded, the largest may be a little below 0.
  return std::sqrt(std::max(0.0, eigenvalues_of(placed)[2]));
}

Surprise surprise(const MountFit& fit, const MarkPair& pair, const CameraModel& model) {
  const auto expected = expected_by(fit.camera.pose.axes, model);
  const Nine numbers = numbers_of(fit.camera);
  const SeenMark missing = pair.seen - expected(numbers, pair);
  const auto slope = slopes<unknowns>(numbers, [&](const Nine& at) { return expected(at, pair); });
  const double own = std::pow(deviation_px(pair), 2);
  const Eigen::Matrix3d may = slope * fit.covariance * slope.transpose() + own * Eigen::Matrix3d::Identity();
  const double deviations = std::sqrt(missing.dot(may.ldlt().solve(missing)));
  const double px = missing.norm();
  return {px, deviations > 0 ? px * gate_deviations / deviations : px};
}

double apart_mm(const forms::CameraPose& one, const forms::CameraPose& other, const Eigen::Vector3d& point_mm) {
  return (CameraView(other, {}).from_camera(CameraView(one, {}).to_camera(point_mm)) - point_mm).norm();
}

}  // namespace pizarra::coordinator
