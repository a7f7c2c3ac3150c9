#include "agents/robot/motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <ranges>

#include "agents/robot/arm_script.hpp"
#include "agents/robot/tool_path.hpp"
#include "drivers/arm/link_geometry.hpp"
#include "lisp/nearest.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr double max_distance_mm = 10'000;
constexpr double max_turn_deg = 360;
constexpr double turn_resolution_deg = 0.01;  // the interface's
constexpr double same_place_deg = 1e-6;

// +1 or -1.
Result<double> sign_of(const Datum& direction, std::string_view positive, std::string_view negative) {
  if (direction.is_symbol(positive)) return 1.0;
  if (direction.is_symbol(negative)) return -1.0;
  return fail("wrong-direction", fmt::format("the direction is {} or {}", positive, negative), direction);
}

// The direction in which an arm extends, in the base frame, for one of the three options.
Result<Eigen::Vector3d> extension(const ArmModel& model, const Joints& from, const Datum& keep) {
  const double turn = from[0] * std::numbers::pi / 180;
  const Eigen::Vector3d ahead(std::cos(turn), std::sin(turn), 0);
  if (keep.is_symbol("keep-height")) return ahead;
  if (keep.is_symbol("keep-distance")) return Eigen::Vector3d(0, 0, 1);
  if (!keep.is_symbol("keep-angle")) {
    return fail("wrong-direction", "what is kept is keep-height, keep-distance or keep-angle", keep);
  }
  const double alpha = link_geometry(model, from).alpha_deg * std::numbers::pi / 180;
  return Eigen::Vector3d(std::cos(alpha) * ahead + std::sin(alpha) * Eigen::Vector3d::UnitZ());
}

// As far as the arm can.
Result<Motion> clamped_line(const ArmModel& model, const Joints& from, const Eigen::Vector3d& along,
                            const Datum& distance) {
  const Result<double> mm = amount_in(distance, 0, max_distance_mm, "mm");
  if (!mm) return fail(mm);
  ToolPath path(model, from);
  const LineEnd end = path.line_by(along * *mm);
  return Motion{path.waypoints(), end.ended_by && path.waypoints().empty()};
}

// All the way or not at all.
Result<Motion> whole_line(const ArmModel& model, const Joints& from, const Eigen::Vector3d& along,
                          const Datum& distance) {
  const Result<double> mm = amount_in(distance, 0, max_distance_mm, "mm");
  if (!mm) return fail(mm);
  ToolPath path(model, from);
  const LineEnd end = path.line_by(along * *mm);
  if (end.ended_by) return fail(*end.ended_by);
  return Motion{path.waypoints()};
}

Result<Motion> turned(const ArmModel& model, const Joints& from, std::size_t axis, double sign, const Datum& angle) {
  const AxisLimits& limits = model.limits[axis];
  const double widest = std::max(max_turn_deg, limits.high_deg - limits.low_deg);
  const Result<double> degrees = amount_in(angle, 0, widest, "degrees");
  if (!degrees) return fail(degrees);
  const double by = std::round(*degrees / turn_resolution_deg) * turn_resolution_deg;
  if (by == 0) return Motion{};
  Joints to = from;
  to[axis] = std::clamp(from[axis] + sign * by, limits.low_deg, limits.high_deg);
  if (std::abs(to[axis] - from[axis]) < turn_resolution_deg / 2) return Motion{{}, true};
  return Motion{{to}};
}

Result<Motion> joint_move(const ArmModel& model, const Joints& from, const Joints& to) {
  const Result<void> within = check_limits(model, to);
  if (!within) return fail(within);
  const bool there = std::ranges::equal(from, to, [](double a, double b) { return std::abs(a - b) < same_place_deg; });
  if (there) return Motion{};
  return Motion{{to}};
}

struct Direction {
  std::string_view operation;
  std::string_view positive;
  std::string_view negative;
};
constexpr Direction directions[] = {{"turn", "right", "left"},
                                    {"turn-wrist", "right", "left"},
                                    {"turn-ef", "up", "down"},
                                    {"move-h", "right", "left"},
                                    {"move-v", "up", "down"}};

Result<Motion> directed(const ArmModel& model, const Datum& operation, const Joints& from) {
  const auto known = std::ranges::find(directions, operation.head(), &Direction::operation);
  const Result<double> sign = sign_of(operation[1], known->positive, known->negative);
  if (!sign) return fail(sign);
  if (operation.is_form("turn")) return turned(model, from, 0, *sign, operation[2]);
  if (operation.is_form("turn-ef")) return turned(model, from, 4, *sign, operation[2]);
  if (operation.is_form("turn-wrist")) return turned(model, from, 5, *sign, operation[2]);
  if (operation.is_form("move-h")) return whole_line(model, from, {0, *sign, 0}, operation[2]);
  return whole_line(model, from, {0, 0, *sign}, operation[2]);
}

}  // namespace

bool is_motion(const Datum& operation) {
  constexpr std::string_view others[] = {"do-action", "retract", "extend", "home", "ready", "goto"};
  return std::ranges::find(others, operation.head()) != std::end(others) ||
         std::ranges::find(directions, operation.head(), &Direction::operation) != std::end(directions);
}

Result<Motion> plan_motion(const ArmModel& model, const Datum& operation, const Joints& from,
                           const ArmVariables& variables) {
  if (operation.is_form("home")) return joint_move(model, from, model.home);
  if (operation.is_form("ready")) return joint_move(model, from, model.ready);
  if (operation.is_form("goto")) {
    const Result<Joints> to = find_variable(variables, operation[1].text());
    if (!to) return fail(to);
    return joint_move(model, from, *to);
  }
  if (operation.is_form("retract")) {
    const Result<Eigen::Vector3d> out = extension(model, from, "keep-height"_sym);
    return clamped_line(model, from, -*out, operation[1]);
  }
  if (operation.is_form("extend")) {
    const Result<Eigen::Vector3d> out = extension(model, from, operation[1]);
    if (!out) return fail(out);
    return clamped_line(model, from, *out, operation[2]);
  }
  if (operation.is_form("do-action")) {
    Result<std::vector<Joints>> waypoints = script_waypoints(model, operation[1].text(), from, variables);
    if (!waypoints) return fail(waypoints);
    return Motion{std::move(*waypoints)};
  }
  return directed(model, operation, from);
}

Result<Joints> find_variable(const ArmVariables& variables, std::string_view name) {
  const auto known = variables.find(name);
  if (known != variables.end()) return known->second;
  const std::string nearest = nearest_name(name, std::views::keys(variables));
  return fail("unknown-variable",
              fmt::format("no variable {} was learned{}", name,
                          nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
              Datum::symbol(name));
}

Result<Motion> rest_of(Motion motion, const Joints& start, const Joints& at) {
  constexpr double astray_deg = 10;
  const auto distance = [&at](const Joints& waypoint) {
    double furthest = 0;
    for (std::size_t axis = 0; axis < arm_axes; ++axis) {
      furthest = std::max(furthest, std::abs(waypoint[axis] - at[axis]));
    }
    return furthest;
  };
  // A joint move of one waypoint passes anything between its ends.
  if (motion.waypoints.size() < 2) return motion;
  const auto nearest = std::ranges::min_element(motion.waypoints, {}, distance);
  if (distance(*nearest) > astray_deg && distance(start) > astray_deg) {
    return fail("stopped", "the arm is no longer where this motion was cut off");
  }
  motion.waypoints.erase(motion.waypoints.begin(), nearest);
  return motion;
}

Result<double> amount_in(const Datum& given, double low, double high, std::string_view unit) {
  const double value = given.number();
  if (value >= low && value <= high) return value;
  return fail("out-of-range", fmt::format("{} is not within {:g} to {:g} {}", write(given), low, high, unit), given);
}

}  // namespace pizarra
