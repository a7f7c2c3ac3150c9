#include "drivers/arm/simple_message/timed_points.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/arm/route.hpp"

namespace pizarra::arm {

namespace {

constexpr double step_s = 0.04;
constexpr int samples = 16;       // of where the arm is within a step
constexpr double pace_per_s = 4;  // to an axis' full speed in a quarter of a second
constexpr double no_way_s = 1e-9;

// How far along a way the arm is that begins and ends at rest: ways are measured in the seconds that they take at the
// axes' full speeds.
class Ramps {
 public:
  Ramps(double way_s, double pace) : way_s_(way_s), pace_(std::min(pace, std::sqrt(way_s * pace_per_s))) {
    ramp_s_ = pace_ / pace_per_s;
    total_s_ = ramp_s_ + way_s_ / pace_;
  }
  double total_s() const { return total_s_; }
  double at(double time_s) const {
    if (time_s >= total_s_) return way_s_;
    if (time_s < ramp_s_) return pace_per_s * time_s * time_s / 2;
    const double left_s = total_s_ - time_s;
    if (left_s < ramp_s_) return way_s_ - pace_per_s * left_s * left_s / 2;
    return pace_ * (time_s - ramp_s_ / 2);
  }

 private:
  double way_s_;
  double pace_;
  double ramp_s_ = 0;
  double total_s_ = 0;
};

class Way {
 public:
  Way(const ArmModel& model, const Joints& from, const std::vector<Joints>& waypoints) : points_{from}, along_s_{0} {
    for (const Joints& waypoint : waypoints) {
      const double further_s = seconds_between(model, points_.back(), waypoint);
      if (further_s <= no_way_s) continue;
      along_s_.push_back(along_s_.back() + further_s);
      points_.push_back(waypoint);
    }
  }
  double whole_s() const { return along_s_.back(); }
  Joints at(double along_s) const {
    const auto next = std::ranges::upper_bound(along_s_, along_s);
    if (next == along_s_.end()) return points_.back();
    const auto end = static_cast<std::size_t>(next - along_s_.begin());
    const double part = (along_s - along_s_[end - 1]) / (along_s_[end] - along_s_[end - 1]);
    Joints joints = points_[end];
    for (std::size_t axis = 0; axis < joints.size(); ++axis) {
      joints[axis] = std::lerp(points_[end - 1][axis], joints[axis], part);
    }
    return joints;
  }

 private:
  std::vector<Joints> points_;
  std::vector<double> along_s_;
};

}  // namespace

std::vector<TimedPoint> timed_points(const ArmModel& model, const Joints& from, const std::vector<Joints>& waypoints,
                                     double speed) {
  const Way way(model, from, waypoints);
  const Joints rest(from.size());
  std::vector<TimedPoint> points{{0, from, rest}};
  if (way.whole_s() <= no_way_s) return points;
  const Ramps ramps(way.whole_s(), speed);
  // Each place is the mean of where the arm would be within a step: so speeds change steadily, in corners too, and no
  // axis gets faster than it is on the way.
  const auto place = [&](double time_s) { return way.at(ramps.at(std::max(time_s, 0.0))); };
  const double whole_s = ramps.total_s() + step_s;
  const auto steps = static_cast<std::size_t>(std::ceil(whole_s / step_s));
  for (std::size_t i = 1; i < steps; ++i) {
    const double time_s = static_cast<double>(i) * whole_s / static_cast<double>(steps);
    TimedPoint point{time_s, rest, rest};
    for (int sample = 0; sample < samples; ++sample) {
      const Joints there = place(time_s - step_s * (sample + 0.5) / samples);
      for (std::size_t axis = 0; axis < rest.size(); ++axis) point.joints[axis] += there[axis] / samples;
    }
    const Joints begin = place(time_s - step_s);
    const Joints end = place(time_s);
    for (std::size_t axis = 0; axis < rest.size(); ++axis) point.speeds[axis] = (end[axis] - begin[axis]) / step_s;
    points.push_back(point);
  }
  points.push_back({whole_s, way.at(way.whole_s()), rest});
  return points;
}

}  // namespace pizarra::arm
