#include "drivers/arm/route.hpp"

#include <algorithm>
#include <cmath>

#include "lisp/numbers.hpp"

namespace pizarra::arm {

namespace {

constexpr double off_axes = 0.05;
constexpr double off_line_mm = 0.2;
constexpr double turned_deg = 0.05;

// The waypoints with where the arm stands before them.
class Way {
 public:
  Way(const ArmModel& model, const Joints& from, const std::vector<Joints>& waypoints) : model_(model), points_{from} {
    points_.insert(points_.end(), waypoints.begin(), waypoints.end());
    for (const Joints& joints : points_) poses_.push_back(forward(model, joints));
  }

  std::size_t last() const { return points_.size() - 1; }
  bool in_proportion(std::size_t begin, std::size_t end) const;
  bool along_a_line(std::size_t begin, std::size_t end) const;
  Leg leg(std::size_t begin, std::size_t end, bool straight) const;

 private:
  bool keeps_direction(std::size_t begin, std::size_t i) const;

  const ArmModel& model_;
  std::vector<Joints> points_;
  std::vector<ToolPose> poses_;
};

// Where on the way from one to the other a point lies nearest, 0 to 1.
double part_of(double along, double squared_length) {
  return squared_length > 0 ? std::clamp(along / squared_length, 0.0, 1.0) : 0.0;
}

bool Way::in_proportion(std::size_t begin, std::size_t end) const {
  const Joints& from = points_[begin];
  const Joints& to = points_[end];
  double length = 0;
  for (std::size_t axis = 0; axis < to.size(); ++axis) length += (to[axis] - from[axis]) * (to[axis] - from[axis]);
  double before = 0;
  for (std::size_t i = begin + 1; i < end; ++i) {
    double along = 0;
    for (std::size_t axis = 0; axis < to.size(); ++axis) {
      along += (points_[i][axis] - from[axis]) * (to[axis] - from[axis]);
    }
    const double part = part_of(along, length);
    if (part < before) return false;
    before = part;
    for (std::size_t axis = 0; axis < to.size(); ++axis) {
      if (std::abs(points_[i][axis] - std::lerp(from[axis], to[axis], part)) > off_axes) return false;
    }
  }
  return true;
}

bool Way::keeps_direction(std::size_t begin, std::size_t i) const {
  const Eigen::AngleAxisd turn(poses_[begin].linear().transpose() * poses_[i].linear());
  return std::abs(degrees(turn.angle())) <= turned_deg;
}

bool Way::along_a_line(std::size_t begin, std::size_t end) const {
  const Eigen::Vector3d from = poses_[begin].translation();
  const Eigen::Vector3d way = poses_[end].translation() - from;
  // One step says nothing of what lies between, and a line that leads nowhere is none.
  if (end < begin + 2 || way.norm() < off_line_mm) return false;
  double before = 0;
  for (std::size_t i = begin + 1; i <= end; ++i) {
    const Eigen::Vector3d here = poses_[i].translation() - from;
    const double part = part_of(here.dot(way), way.squaredNorm());
    if (part < before || (here - part * way).norm() > off_line_mm || !keeps_direction(begin, i)) return false;
    before = part;
  }
  return true;
}

Leg Way::leg(std::size_t begin, std::size_t end, bool straight) const {
  Leg leg{.to = points_[end], .straight = straight};
  for (std::size_t i = begin; i < end; ++i) leg.seconds += seconds_between(model_, points_[i], points_[i + 1]);
  return leg;
}

// The furthest end, from `begin` on, for which `holds` is true; it is for the next.
template <class Holds>
std::size_t furthest(std::size_t begin, std::size_t last, Holds holds) {
  if (holds(last)) return last;
  std::size_t good = begin + 1;
  std::size_t bad = last;
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (holds(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace

double seconds_between(const ArmModel& model, const Joints& from, const Joints& to) {
  double longest = 0;
  for (std::size_t axis = 0; axis < to.size(); ++axis) {
    longest = std::max(longest, std::abs(to[axis] - from[axis]) / model.axes[axis].speed);
  }
  return longest;
}

bool are_same_place(const Joints& one, const Joints& other, double within) {
  for (std::size_t axis = 0; axis < one.size(); ++axis) {
    if (std::abs(one[axis] - other[axis]) > within) return false;
  }
  return true;
}

std::vector<Leg> legs_of(const ArmModel& model, const Joints& from, const std::vector<Joints>& waypoints) {
  const Way way(model, from, waypoints);
  std::vector<Leg> legs;
  std::size_t begin = 0;
  while (begin < way.last()) {
    const std::size_t joint_end =
        furthest(begin, way.last(), [&](std::size_t end) { return way.in_proportion(begin, end); });
    const std::size_t line_end =
        furthest(begin, way.last(), [&](std::size_t end) { return end == begin + 1 || way.along_a_line(begin, end); });
    const bool straight = line_end > joint_end;
    const std::size_t end = straight ? line_end : joint_end;
    legs.push_back(way.leg(begin, end, straight));
    begin = end;
  }
  return legs;
}

}  // namespace pizarra::arm
