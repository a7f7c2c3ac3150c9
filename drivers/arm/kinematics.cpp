#include "drivers/arm/kinematics.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "drivers/arm/placement.hpp"
#include "drivers/arm/solution.hpp"

namespace pizarra::arm {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double track_step_mm = 10;
constexpr double fine_track_step_mm = 1;
constexpr double track_resolution_mm = 1e-3;

// With the coordinate that leads furthest from where the arm is; none where only the tool's direction differs.
std::unexpected<Failure> out_of_reach(const ArmModel& model, const ToolPose& pose, const Joints& near) {
  constexpr double same_mm = 0.05;
  const Vector3d at = (pose.translation() * 10).array().round() / 10;
  Eigen::Index furthest = 0;
  const Vector3d way_mm = pose.translation() - forward(model, near).translation();
  const bool led = way_mm.cwiseAbs().maxCoeff(&furthest) > same_mm;
  const std::string which = led ? fmt::format(", {} leads out of its reach", "xyz"[furthest]) : "";
  return fail("unreachable", "the arm cannot reach this point with this tool direction" + which,
              list("point"_sym, at.x(), at.y(), at.z()));
}

Result<Joints> answer_of(const ArmModel& model, const ToolPose& pose, const Joints& near, const Solution& best) {
  if (!best.found) return out_of_reach(model, pose, near);
  const Result<void> within = check_limits(model, best.joints);
  if (!within) return fail(within);
  Joints joints = best.joints;
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    joints[axis] = std::clamp(joints[axis], model.axes[axis].limits.low, model.axes[axis].limits.high);
  }
  return joints;
}

// Where along its track the arm can reach the pose with `margin` to spare, nearest to where it stands. Looked for in
// steps to both sides, then narrowed down.
class TrackSearch {
 public:
  // `most_deg`: by which another axis may turn from `near`.
  TrackSearch(const ArmModel& model, const ToolPose& pose, const Joints& near, std::size_t track,
              double most_deg = std::numeric_limits<double>::infinity())
      : model_(model), pose_(pose), near_(near), track_(track), most_deg_(most_deg) {}

  bool within_reach() const {
    const Axis& axis = model_.axes[track_];
    const Vector3d along = model_.track_along_x ? Vector3d::UnitX() : Vector3d::UnitY();
    const double a = axis.sense * axis.limits.low + axis.zero;
    const double b = axis.sense * axis.limits.high + axis.zero;
    const Vector3d wrist = wrist_of(model_, pose_);
    const double at = std::clamp(wrist.dot(along), std::min(a, b), std::max(a, b));
    return (wrist - at * along).norm() <= longest_reach_mm(model_);
  }

  std::optional<Joints> nearest(double step_mm, double margin_deg) const {
    const Range limits = model_.axes[track_].limits;
    const double here = near_[track_];
    for (double away = step_mm; here - away > limits.low - step_mm || here + away < limits.high + step_mm;
         away += step_mm) {
      for (const double side : {-1.0, 1.0}) {
        const double bad = std::clamp(here + side * (away - step_mm), limits.low, limits.high);
        const double good = std::clamp(here + side * away, limits.low, limits.high);
        if (bad == good || !at(good, margin_deg)) continue;
        return narrowed(bad, good, margin_deg);
      }
    }
    return std::nullopt;
  }

 private:
  std::optional<Joints> at(double track_mm, double margin_deg) const {
    Joints from = near_;
    from[track_] = track_mm;
    const Solution best = best_solution(model_, pose_, from);
    if (!best.found || best.excess > 0 || margin_of(model_, best.joints) < margin_deg) return std::nullopt;
    for (std::size_t axis = 0; axis < near_.size(); ++axis) {
      const bool turns = !slides(model_.axes[axis].role);
      if (turns && std::abs(best.joints[axis] - near_[axis]) > most_deg_) return std::nullopt;
    }
    return best.joints;
  }

  Joints narrowed(double bad, double good, double margin_deg) const {
    Joints best = *at(good, margin_deg);
    while (std::abs(good - bad) > track_resolution_mm) {
      const double middle = (bad + good) / 2;
      const std::optional<Joints> tried = at(middle, margin_deg);
      (tried ? good : bad) = middle;
      if (tried) best = *tried;
    }
    return best;
  }

  const ArmModel& model_;
  const ToolPose& pose_;
  const Joints& near_;
  std::size_t track_;
  double most_deg_;
};

}  // namespace

Result<Joints> inverse_in_place(const ArmModel& model, const ToolPose& pose, const Joints& near) {
  if (!pose.matrix().allFinite()) return fail("unreachable", "the pose holds a number that is not finite");
  return answer_of(model, pose, near, best_solution(model, pose, near));
}

Result<Joints> inverse(const ArmModel& model, const ToolPose& pose, const Joints& near) {
  const std::optional<std::size_t> track = model.axis_of(Role::track);
  if (!track || !pose.matrix().allFinite()) return inverse_in_place(model, pose, near);
  const Solution here = best_solution(model, pose, near);
  const bool reached = here.found && here.excess == 0;
  if (reached && margin_of(model, here.joints) >= track_margin_deg) return answer_of(model, pose, near, here);
  const TrackSearch search(model, pose, near, *track);
  if (!search.within_reach()) return answer_of(model, pose, near, here);
  std::optional<Joints> elsewhere = search.nearest(track_step_mm, track_margin_deg);
  if (!elsewhere && !reached) elsewhere = search.nearest(fine_track_step_mm, 0);
  if (elsewhere) return answer_of(model, pose, near, {true, *elsewhere, 0});
  return answer_of(model, pose, near, here);
}

Result<Joints> inverse_elsewhere(const ArmModel& model, const ToolPose& pose, const Joints& near, double most_deg) {
  const std::optional<std::size_t> track = model.axis_of(Role::track);
  std::optional<Joints> elsewhere;
  if (track && pose.matrix().allFinite()) {
    const TrackSearch search(model, pose, near, *track, most_deg);
    if (search.within_reach()) elsewhere = search.nearest(fine_track_step_mm, 0);
  }
  return answer_of(model, pose, near, elsewhere ? Solution{true, *elsewhere, 0} : Solution{});
}

Result<void> check_limits(const ArmModel& model, const Joints& joints) {
  if (joints.size() != model.axes.size()) {
    return fail("bad-joints",
                fmt::format("the arm has {} axes, and {} angles were given", model.axes.size(), joints.size()),
                to_datum(joints.size()));
  }
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    if (!std::isfinite(joints[axis])) {
      return fail("not-finite", fmt::format("axis {} is given no finite angle", axis + 1), to_datum(axis + 1));
    }
  }
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    const Range range = range_of(model, joints, axis);
    if (excess_of(range, joints[axis]) == 0) continue;
    const bool stopped = excess_of(model.axes[axis].limits, joints[axis]) == 0;
    return fail("joint-limit",
                fmt::format("axis {} would stand at {:.2f} {}, beyond {} {:g} to {:g}", axis + 1, joints[axis],
                            slides(model.axes[axis].role) ? "mm" : "degrees",
                            stopped ? "what its stops leave here," : "its", range.low, range.high),
                to_datum(axis + 1));
  }
  return {};
}

std::array<double, 3> fixed_angles(const Matrix3d& rotation) {
  constexpr double upright = 1e-7;
  const double level = std::hypot(rotation(0, 0), rotation(1, 0));
  double rx = std::atan2(rotation(2, 1), rotation(2, 2));
  double rz = std::atan2(rotation(1, 0), rotation(0, 0));
  // With the y angle upright, x and z turn about one axis; z is then taken as 0.
  if (level < upright) {
    rx = std::atan2(-rotation(1, 2), rotation(1, 1));
    rz = 0;
  }
  const double ry = std::atan2(-rotation(2, 0), level);
  const auto upper_half = [](double rad) { return rad <= -std::numbers::pi ? 180 : degrees(rad); };
  return {upper_half(rx), degrees(ry), upper_half(rz)};
}

}  // namespace pizarra::arm
