#include "agents/robot/jog.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "agents/robot/tool_path.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::robot {

namespace {

constexpr double jog_line_mm = 600;
constexpr double jog_turn_deg = 360;
constexpr double jog_turn_step_deg = 1;

// A straight line along a base axis, or an operation that is clamped to what the arm can do.
struct JogWay {
  std::string_view name;
  double across;  // along the base's y
  double up;
  std::string_view operation;
  std::string_view argument;
};

constexpr JogWay jog_ways[] = {
    {"left", -1, 0, {}, {}},
    {"right", 1, 0, {}, {}},
    {"up", 0, 1, {}, {}},
    {"down", 0, -1, {}, {}},
    {"out", 0, 0, "extend", "keep-height"},
    {"in", 0, 0, "retract", {}},
    {"turn-left", 0, 0, "turn", "left"},
    {"turn-right", 0, 0, "turn", "right"},
    {"tool-up", 0, 0, "turn-ef", "up"},
    {"tool-down", 0, 0, "turn-ef", "down"},
    {"wrist-left", 0, 0, "turn-wrist", "left"},
    {"wrist-right", 0, 0, "turn-wrist", "right"},
};

bool is_turn(const JogWay& way) { return way.operation.starts_with("turn"); }

Result<Motion> planned(const arm::ArmModel& model, const JogWay& way, const arm::Joints& from) {
  if (way.operation.empty()) {
    ToolPath path(model, from);
    const LineEnd end = path.line_by(Eigen::Vector3d(0, way.across, way.up) * jog_line_mm);
    if (end.ended_by && end.ended_by->symbol == "singular" && path.waypoints().empty()) return fail(*end.ended_by);
    return Motion{path.waypoints(), path.waypoints().empty()};
  }
  std::vector<Datum> form{Datum::symbol(way.operation)};
  if (!way.argument.empty()) form.push_back(Datum::symbol(way.argument));
  form.push_back(to_datum(is_turn(way) ? jog_turn_deg : jog_line_mm));
  return plan_motion(model, Datum::list(std::move(form)), from, {});
}

// So that every leg is short enough for its chord to be its arc.
std::vector<arm::Joints> in_small_steps(const arm::Joints& from, const std::vector<arm::Joints>& waypoints) {
  std::vector<arm::Joints> steps;
  arm::Joints at = from;
  for (const arm::Joints& to : waypoints) {
    double widest = 0;
    for (std::size_t axis = 0; axis < to.size(); ++axis) widest = std::max(widest, std::abs(to[axis] - at[axis]));
    const double pieces = std::max(1.0, std::ceil(widest / jog_turn_step_deg));
    for (double piece = 1; piece <= pieces; ++piece) {
      arm::Joints step = to;
      for (std::size_t axis = 0; axis < to.size(); ++axis) step[axis] = std::lerp(at[axis], to[axis], piece / pieces);
      steps.push_back(step);
    }
    at = to;
  }
  return steps;
}

// Up to where it would leave the room, once it is in it.
void keep_in_room(const arm::ArmModel& model, const WorkVolume& room, const arm::Joints& from,
                  std::vector<arm::Joints>& waypoints) {
  bool inside = room.holds(arm::forward(model, from).translation());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const bool now = room.holds(arm::forward(model, waypoints[i]).translation());
    if (inside && !now) break;
    inside = inside || now;
    if (now) kept = i + 1;
  }
  waypoints.resize(kept);
}

}  // namespace

Result<Motion> plan_jog(const arm::ArmModel& model, const std::optional<WorkVolume>& room, std::string_view direction,
                        const arm::Joints& from) {
  const auto* way = std::ranges::find(jog_ways, direction, &JogWay::name);
  if (way == std::end(jog_ways)) {
    std::string known;
    for (const JogWay& each : jog_ways) known += fmt::format("{}{}", known.empty() ? "" : ", ", each.name);
    return fail("wrong-direction", fmt::format("a jog goes {}", known), Datum::symbol(direction));
  }
  Result<Motion> motion = planned(model, *way, from);
  if (!motion) return motion;
  if (is_turn(*way)) motion->waypoints = in_small_steps(from, motion->waypoints);
  if (room) keep_in_room(model, *room, from, motion->waypoints);
  motion->at_limit = motion->waypoints.empty();
  return motion;
}

double jog_speed(const arm::ArmModel& model, const arm::Joints& from, const std::vector<arm::Joints>& waypoints,
                 Duration deadline) {
  const double blind_s = std::chrono::duration<double>(deadline + jog_stopping).count();
  double part = 1;
  arm::Joints at = from;
  arm::ToolPose pose = arm::forward(model, from);
  for (const arm::Joints& to : waypoints) {
    const arm::ToolPose next = arm::forward(model, to);
    double full_speed_s = 0;
    for (std::size_t axis = 0; axis < to.size(); ++axis) {
      full_speed_s = std::max(full_speed_s, std::abs(to[axis] - at[axis]) / model.axes[axis].speed);
    }
    const double way_mm = (next.translation() - pose.translation()).norm();
    const Eigen::AngleAxisd turned(pose.linear().transpose() * next.linear());
    const double overruns = std::max(way_mm / jog_overrun_mm, degrees(turned.angle()) / jog_overrun_deg);
    if (overruns > 0) part = std::min(part, full_speed_s / (overruns * blind_s));
    at = to;
    pose = next;
  }
  return part;
}

}  // namespace pizarra::robot
