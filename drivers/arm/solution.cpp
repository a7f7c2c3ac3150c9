#include "drivers/arm/solution.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "drivers/arm/placement.hpp"

namespace pizarra::arm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double reading_slack = 1e-5;      // degrees or mm: the arc cosine of a stretched elbow is no better
constexpr double singular_sine = 1e-7;      // below it the axes of roll and spin count as one
constexpr double direction_slack = 1.2e-5;  // radians that a wrist of fewer axes may be off: 0.0007 degree

Vector3d along_track(const ArmModel& model) { return model.track_along_x ? Vector3d::UnitX() : Vector3d::UnitY(); }

// The same direction of an axis, whole turns away, that lies nearest `near` within the limits; the nearest to the
// limits where none lies within.
double nearest_turn(double deg, double near_deg, const Range& limits) {
  double best = deg + 360 * std::round((near_deg - deg) / 360);
  if (best > limits.high + reading_slack) best -= 360 * std::ceil((best - limits.high - reading_slack) / 360);
  if (best < limits.low - reading_slack) {
    const double raised = best + 360 * std::ceil((limits.low - reading_slack - best) / 360);
    if (raised <= limits.high + reading_slack) best = raised;
  }
  return best;
}

// The wrist's axes for Rz(-roll) Ry(pitch) Rz(-spin) = `turned`; at most two ways.
struct Wrists {
  std::array<std::array<double, 3>, 2> ways;  // roll, pitch, spin
  std::size_t count = 0;
};

double spin_of(const Matrix3d& rest) { return -degrees(std::atan2(rest(1, 0), rest(1, 1))); }

Wrists full_wrists(const Matrix3d& turned, double near_roll) {
  Wrists wrists;
  const double sine = std::hypot(turned(0, 2), turned(1, 2));
  for (const double flip : {1.0, -1.0}) {
    const double pitch = degrees(std::atan2(flip * sine, turned(2, 2)));
    double roll = near_roll;
    if (sine > singular_sine) roll = -degrees(std::atan2(flip * turned(1, 2), flip * turned(0, 2)));
    wrists.ways[wrists.count++] = {roll, pitch, spin_of(about_z(roll) * turned)};
  }
  return wrists;
}

// Without an axis of roll, and perhaps of pitch, only some directions can be had.
Wrists lesser_wrists(const Matrix3d& turned, bool pitches) {
  Wrists wrists;
  if (std::abs(turned(1, 2)) > direction_slack) return wrists;
  if (!pitches && (std::abs(turned(0, 2)) > direction_slack || turned(2, 2) < 0)) return wrists;
  const double pitch = pitches ? std::atan2(turned(0, 2), turned(2, 2)) : 0;
  wrists.ways[wrists.count++] = {0, degrees(pitch), spin_of(turned)};
  return wrists;
}

// What the search keeps of the arm: which wrist it has, and where `near` is.
class Chooser {
 public:
  Chooser(const ArmModel& model, const Joints& near) : model_(model), near_(near) {}

  void consider(const Posture& posture) {
    Joints joints = joints_of(model_, posture);
    for (std::size_t axis = 0; axis < joints.size(); ++axis) {
      if (slides(model_.axes[axis].role)) continue;
      joints[axis] = nearest_turn(joints[axis], near_[axis], model_.axes[axis].limits);
    }
    double excess = 0;
    double distance = 0;
    for (std::size_t axis = 0; axis < joints.size(); ++axis) {
      excess += excess_of(range_of(model_, joints, axis), joints[axis]);
      distance += (joints[axis] - near_[axis]) * (joints[axis] - near_[axis]);
    }
    const bool better = excess < best_.excess || (excess == best_.excess && distance < distance_);
    if (best_.found && !better) return;
    best_ = {true, joints, excess};
    distance_ = distance;
  }

  const Solution& best() const { return best_; }

 private:
  const ArmModel& model_;
  const Joints& near_;
  Solution best_;
  double distance_ = 0;
};

// Where the wrist centre may be: a tool beside its pitch axis hangs to one side of it or, with axis 1 half a turn away,
// to the other. Without the track.
struct WristPlaces {
  std::array<Vector3d, 2> places;
  std::size_t count = 0;
};

WristPlaces wrist_places(const ArmModel& model, const ToolPose& pose, const Vector3d& track, double heading_deg) {
  WristPlaces wrists;
  const Vector3d over = wrist_of(model, pose) - track;
  if (model.wrist_across_mm == 0) {
    wrists.places[wrists.count++] = over;
    return wrists;
  }
  const std::optional<Bearing> bearing = bearing_of(model, pose.translation() - track, heading_deg);
  if (!bearing) return wrists;
  for (const double turn : {bearing->front_deg, bearing->back_deg}) {
    const Vector3d right = about_z(turn) * -Vector3d::UnitY();
    wrists.places[wrists.count++] = over - model.wrist_across_mm * right.cross(pose.linear().col(2));
  }
  return wrists;
}

// Where axis 1 stands when the wrist centre is on it: a wrist without roll has only the tool's own heading.
double free_heading(const ArmModel& model, const ToolPose& pose, const Posture& near) {
  const Vector3d approach = pose.linear().col(2);
  const bool rolls = model.axis_of(Role::roll).has_value();
  if (rolls || std::hypot(approach.x(), approach.y()) < singular_sine) return near.place[0];
  return degrees(std::atan2(approach.y(), approach.x()));
}

bool reaches(const ArmModel& model, const Posture& posture, const ToolPose& pose) {
  constexpr double near_mm = 1e-3;
  return (forward(model, joints_of(model, posture)).translation() - pose.translation()).norm() < near_mm;
}

}  // namespace

double excess_of(const Range& range, double reading) {
  return std::max({0.0, range.low - reading_slack - reading, reading - range.high - reading_slack});
}

Vector3d wrist_of(const ArmModel& model, const ToolPose& pose) {
  return pose.translation() - (model.wrist_mm + model.tool_mm) * pose.linear().col(2);
}

double margin_of(const ArmModel& model, const Joints& joints) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    const Role role = model.axes[axis].role;
    if (role != Role::shoulder && role != Role::elbow && role != Role::pitch) continue;
    const Range range = range_of(model, joints, axis);
    least = std::min({least, joints[axis] - range.low, range.high - joints[axis]});
  }
  return least;
}

Solution best_solution(const ArmModel& model, const ToolPose& pose, const Joints& near) {
  const Posture from = posture_of(model, near);
  const Vector3d track = from.track_mm * along_track(model);
  const bool rolls = model.axis_of(Role::roll).has_value();
  const bool pitches = model.axis_of(Role::pitch).has_value();
  const double heading = free_heading(model, pose, from);
  const WristPlaces wrists_at = wrist_places(model, pose, track, heading);
  Chooser chooser(model, near);
  Ways ways;
  for (std::size_t i = 0; i < wrists_at.count; ++i) ways.append(ways_to(model, wrists_at.places[i], heading));
  for (std::size_t way = 0; way < ways.count; ++way) {
    Posture posture = from;
    posture.place = ways.ways[way];
    const Matrix3d turned = place(model, posture).forearm.transpose() * pose.linear();
    const Wrists wrists = rolls ? full_wrists(turned, from.roll_deg) : lesser_wrists(turned, pitches);
    for (std::size_t i = 0; i < wrists.count; ++i) {
      posture.roll_deg = wrists.ways[i][0];
      posture.pitch_deg = wrists.ways[i][1];
      posture.spin_deg = wrists.ways[i][2];
      // The wrist's place was reckoned for one way to stand, and is wrong for the other.
      if (model.wrist_across_mm != 0 && !reaches(model, posture, pose)) continue;
      chooser.consider(posture);
    }
  }
  return chooser.best();
}

}  // namespace pizarra::arm
