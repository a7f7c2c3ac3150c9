#pragma once

// Where the camera stands, solved from looks at the gripper's mark: each pair is what the camera saw of the mark, and
// where the arm said that its tool was. Unknown are the six numbers of the camera's pose and the mark's place in the
// tool's frame. All nine have a guess with a standard deviation, so that whatever the pairs leave open stays as it was
// guessed. Pairs that do not agree with the others weigh less.
//
//   const MountedCamera guess{.pose = {{1350, 0, 190}, 2, 0, 0}};
//   const MountFit fit = fit_mount(guess, {.at_mm = 20, .turned_deg = 2, .mark_mm = 0.5}, pairs, model);
//   fit.camera.pose;                     // ... and how sure that is:
//   fit.spread_mm({450, 0, 30});         // of a point there, as the camera places it

#include <Eigen/Geometry>
#include <optional>
#include <span>
#include <vector>

#include "agents/coordinator/geometry/camera_view.hpp"

namespace pizarra::coordinator {

struct MountedCamera {
  forms::CameraPose pose;
  Eigen::Vector3d mark_mm{30, 0, -66};  // in the tool's frame
};

// Standard deviations of a guess, each of its coordinates.
struct Sureness {
  double at_mm;
  double turned_deg;
  double mark_mm;
};

// A point in the left image, and its disparity, which tells the depth; px.
using SeenMark = Eigen::Vector3d;

// One or more looks at the mark while the arm stood still.
struct MarkPair {
  Eigen::Isometry3d tool;  // base frame, mm
  HeadTurn head;           // how the camera was turned from its pose
  SeenMark seen;           // the mean of its looks
  int looks = 1;
};

// Of a point before the camera.
SeenMark seen_mark(const CameraView& view, const Eigen::Vector3d& point_mm);
SeenMark expected_mark(const MountedCamera& camera, const MarkPair& pair, const CameraModel& model);
Eigen::Isometry3d tool_pose(const Eigen::Vector3d& at_mm, double rx_deg, double ry_deg, double rz_deg);

struct MountFit {
  using Covariance = Eigen::Matrix<double, 9, 9>;
  MountedCamera camera;
  Covariance covariance;  // of x, y, z, pan, tilt, roll, mark; mm and degrees
  double error_px = 0;    // root mean square over the pairs, each coordinate

  // How far a point of the base frame may be placed off: the largest standard deviation, in any direction.
  double spread_mm(const Eigen::Vector3d& point_mm) const;
};

MountFit fit_mount(const MountedCamera& guess, const Sureness& sure, std::span<const MarkPair> pairs,
                   const CameraModel& model);

// Where the camera stands by the pairs alone, without a guess. None where they do not tell: they are fewer than four,
// were seen with the head turned otherwise, or lie too close together or along a line.
std::optional<forms::CameraPose> pose_from_pairs(const Eigen::Vector3d& mark_mm, std::span<const MarkPair> pairs,
                                                 const CameraModel& model);

// How far from the expected place the mark was seen, px, and what that may be at most if the pair agrees with the fit.
struct Surprise {
  double px;
  double most_px;
  bool is_one() const { return px > most_px; }
};
Surprise surprise(const MountFit& fit, const MarkPair& pair, const CameraModel& model);

// How far apart two poses place what is at a point of the base frame by the first.
double apart_mm(const forms::CameraPose& one, const forms::CameraPose& other, const Eigen::Vector3d& point_mm);

}  // namespace pizarra::coordinator
