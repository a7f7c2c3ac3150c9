#pragma once

// A path of the grip centre through straight pieces, the tool's direction kept (as nearly as the arm's axes can), as
// waypoints that an arm follows by joint interpolation. Waypoints stand at most 5 mm apart, and nearer where the way
// between two of them would leave the line, as where a track begins to help or the wrist turns fast. A line which no
// waypoints keep the arm on is not followed (`singular`).
//
//   ToolPath path(model, joints);
//   LineEnd end = path.line_by({0, 0, -50});
//   if (!end.ended_by) start(path.waypoints());

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "drivers/arm/kinematics.hpp"

namespace pizarra::robot {

struct LineEnd {
  double length_mm;                 // how far the path got along this piece
  std::optional<Failure> ended_by;  // why no further: unreachable, joint-limit, singular; nothing where it got there
};

class ToolPath {
 public:
  static constexpr double step_mm = 5;
  // The path is checked at a quarter, half and three quarters of the way between two waypoints. There the grip centre
  // is no further from the line, and the tool no further from the directions that it has at both ends; which keeps all
  // the way within 0.1 mm.
  static constexpr double deviation_mm = 0.05;
  static constexpr double tilt_rad = 1e-3;
  // How near to a limit a line is followed, and how near to each other waypoints are put.
  static constexpr double resolution_mm = 0.01;
  // An axis that turns further between two waypoints is changing posture, which no straight line survives.
  static constexpr double posture_change_deg = 30;
  static constexpr double posture_change_mm = 100;
  static constexpr std::size_t max_waypoints = 2000;

  // Whether a track may carry the arm on where its links do not reach.
  enum class Track { helps, stays };

  ToolPath(const arm::ArmModel& model, const arm::Joints& from, Track track = Track::helps);

  // Goes on along a straight line, as far as the arm can.
  LineEnd line_by(const Eigen::Vector3d& offset_mm);
  LineEnd line_to(const Eigen::Vector3d& point_mm) { return line_by(point_mm - point()); }
  // The same, all the way. Failures: unreachable, joint-limit, singular.
  Result<void> reach_by_line(const Eigen::Vector3d& point_mm);
  // Goes on with a joint move.
  Result<void> joints_to(const arm::Joints& joints);

  // Where it ends so far.
  Eigen::Vector3d point() const { return pose_.translation(); }
  const arm::Joints& joints() const { return joints_; }
  // Without the joints it started from.
  const std::vector<arm::Joints>& waypoints() const { return waypoints_; }

 private:
  Result<arm::Joints> reach(const Eigen::Vector3d& point_mm) const;
  Result<void> keeps_posture(const arm::Joints& joints, const Eigen::Vector3d& point_mm) const;
  void append(const arm::Joints& joints, const Eigen::Vector3d& point_mm);
  struct Line {
    Eigen::Vector3d start_mm;
    Eigen::Vector3d along;
    Eigen::Vector3d at(double way_mm) const { return start_mm + along * way_mm; }
  };
  bool is_straight(const Line& line, const arm::Joints& to) const;
  // Goes on from one place of the line, where it ends, to another; how far it got, from the line's start.
  LineEnd advance(const Line& line, double from_mm, double to_mm);
  // The last piece of a line that cannot be followed to `to_mm`.
  double advance_as_far_as_it_can(const Line& line, double from_mm, double to_mm);
  Failure singular(const arm::Joints& to, double way_mm) const;

  const arm::ArmModel& model_;
  const Track track_;
  arm::Joints joints_;
  arm::ToolPose pose_;
  std::vector<arm::Joints> waypoints_;
};

}  // namespace pizarra::robot
