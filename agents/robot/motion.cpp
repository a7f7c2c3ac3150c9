#include "agents/robot/motion.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <ranges>

#include "agents/robot/arm_script.hpp"
#include "agents/robot/tool_path.hpp"
#include "drivers/arm/posture.hpp"
#include "lisp/nearest.hpp"
#include "lisp/numbers.hpp"
#include "lisp/writer.hpp"

namespace pizarra::robot {

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
Result<Eigen::Vector3d> extension(const arm::ArmModel& model, const arm::Joints& from, const Datum& keep) {
  const arm::Stretch stretch = arm::stretch_of(model, from);
  if (keep.is_symbol("keep-height")) return stretch.ahead;
  if (keep.is_symbol("keep-distance")) return Eigen::Vector3d(0, 0, 1);
  if (!keep.is_symbol("keep-angle")) {
    return fail("wrong-direction", "extend knows keep-height, keep-distance and keep-angle", keep);
  }
  const double alpha = std::atan2(stretch.h_mm, stretch.d_mm);
  return Eigen::Vector3d(std::cos(alpha) * stretch.ahead + std::sin(alpha) * Eigen::Vector3d::UnitZ());
}

// As far as the arm can.
Result<Motion> clamped_line(const arm::ArmModel& model, const arm::Joints& from, const Eigen::Vector3d& along,
                            const Datum& distance, ToolPath::Track track) {
  const Result<double> mm = clamped_amount(distance, max_distance_mm, "mm");
  if (!mm) return fail(mm);
  ToolPath path(model, from, track);
  const LineEnd end = path.line_by(along * *mm);
  const bool is_singular = end.ended_by && end.ended_by->symbol == "singular";
  // From the end of an axis a track would have to help at once. The links alone may keep to the line.
  if (is_singular && track == ToolPath::Track::helps) {
    return clamped_line(model, from, along, distance, ToolPath::Track::stays);
  }
  // A singular pose on the way is a failure, and not the end of the reach.
  if (is_singular) return fail(*end.ended_by);
  // Less than a line may be off is no way to go.
  if (end.ended_by && end.length_mm < ToolPath::deviation_mm) return Motion{{}, true};
  return Motion{path.waypoints()};
}

// What stretches or folds the links is carried on only by a track that runs the same way.
Result<Motion> stretched(const arm::ArmModel& model, const arm::Joints& from, const Eigen::Vector3d& along,
                         const Datum& distance) {
  const auto track = model.track_along_x ? ToolPath::Track::helps : ToolPath::Track::stays;
  return clamped_line(model, from, along, distance, track);
}

double to_resolution(double degrees) { return std::round(degrees / turn_resolution_deg) * turn_resolution_deg; }

// Of an arm that no axis turns: its tool goes where it would if the whole arm were turned about the base's upright, on
// the same arc, as far as the arm reaches.
Result<Motion> carried_round(const arm::ArmModel& model, const arm::Joints& from, double sign, const Datum& angle) {
  constexpr double step_deg = 1;
  const Result<double> degrees = clamped_amount(angle, max_turn_deg, "degrees");
  if (!degrees) return fail(degrees);
  const double by = to_resolution(*degrees);
  const arm::ToolPose start = arm::forward(model, from);
  Motion motion;
  const auto reach = [&](double turned_deg) {
    const Eigen::AngleAxisd turn(radians(sign * turned_deg), Eigen::Vector3d::UnitZ());
    const arm::Joints& near = motion.waypoints.empty() ? from : motion.waypoints.back();
    const Result<arm::Joints> joints = arm::inverse_in_place(model, arm::ToolPose(turn) * start, near);
    if (joints) motion.waypoints.push_back(*joints);
    return joints.has_value();
  };
  const double arc_mm = start.translation().head<2>().norm() * radians(by);
  const double steps = std::ceil(std::max(by / step_deg, arc_mm / ToolPath::step_mm));
  for (double step = 1; step <= steps; ++step) {
    if (reach(by * step / steps)) continue;
    // Nearer and nearer to where it reaches no further.
    double piece = by / steps / 2;
    for (double at = by * (step - 1) / steps; piece >= turn_resolution_deg / 2; piece /= 2) {
      if (reach(at + piece)) at += piece;
    }
    break;
  }
  motion.at_limit = by > 0 && motion.waypoints.empty();
  return motion;
}

// What an arm without this axis does instead.
std::string without_axis(const arm::ArmModel& model, arm::Role role) {
  if (role != arm::Role::pitch) {
    return fmt::format("the arm {} has no axis that does this ({})", model.type, arm::role_name(role));
  }
  return fmt::format("the tool of the arm {} always points down: (turn-wrist ...) turns it, and nothing tilts it",
                     model.type);
}

// `sign` counts as the role's value does, whatever the axis' own sense.
Result<Motion> turned(const arm::ArmModel& model, const arm::Joints& from, arm::Role role, double sign,
                      const Datum& angle) {
  const std::optional<std::size_t> known = model.axis_of(role);
  if (!known && role == arm::Role::turn) return carried_round(model, from, sign, angle);
  if (!known) return fail("no-such-axis", without_axis(model, role), Datum::symbol(arm::role_name(role)));
  const std::size_t axis = *known;
  const arm::Range range = arm::range_of(model, from, axis);
  const double widest = std::max(max_turn_deg, range.high - range.low);
  const Result<double> degrees = clamped_amount(angle, widest, "degrees");
  if (!degrees) return fail(degrees);
  const double by = to_resolution(*degrees);
  if (by == 0) return Motion{};
  arm::Joints to = from;
  to[axis] = std::clamp(from[axis] + sign * model.axes[axis].sense * by, std::min(range.low, from[axis]),
                        std::max(range.high, from[axis]));
  if (std::abs(to[axis] - from[axis]) < turn_resolution_deg / 2) return Motion{{}, true};
  return Motion{{to}};
}

Result<Motion> line_to(const arm::ArmModel& model, const arm::Joints& from, const Datum& operation) {
  ToolPath path(model, from);
  const Result<void> done = path.reach_by_line({operation[1].number(), operation[2].number(), operation[3].number()});
  if (!done) return fail(done);
  return Motion{path.waypoints()};
}

Result<Motion> joint_move(const arm::ArmModel& model, const arm::Joints& from, const arm::Joints& to) {
  const Result<void> within = arm::check_limits(model, to);
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

Result<Motion> directed(const arm::ArmModel& model, const Datum& operation, const arm::Joints& from) {
  const auto known = std::ranges::find(directions, operation.head(), &Direction::operation);
  constexpr auto helps = ToolPath::Track::helps;
  const Result<double> sign = sign_of(operation[1], known->positive, known->negative);
  if (!sign) return fail(sign);
  if (operation.is_form("turn")) return turned(model, from, arm::Role::turn, *sign, operation[2]);
  if (operation.is_form("turn-ef")) return turned(model, from, arm::Role::pitch, *sign, operation[2]);
  if (operation.is_form("turn-wrist")) return turned(model, from, arm::Role::spin, *sign, operation[2]);
  if (operation.is_form("move-h")) return clamped_line(model, from, {0, *sign, 0}, operation[2], helps);
  return clamped_line(model, from, {0, 0, *sign}, operation[2], helps);
}

}  // namespace

bool is_motion(const Datum& operation) {
  constexpr std::string_view others[] = {"do-action", "move-to", "retract", "extend", "home", "ready", "goto"};
  return std::ranges::find(others, operation.head()) != std::end(others) ||
         std::ranges::find(directions, operation.head(), &Direction::operation) != std::end(directions);
}

Result<Motion> plan_motion(const arm::ArmModel& model, const Datum& operation, const arm::Joints& from,
                           const ArmVariables& variables) {
  if (operation.is_form("home")) return joint_move(model, from, model.home);
  if (operation.is_form("ready")) return joint_move(model, from, model.ready);
  if (operation.is_form("goto")) {
    const Result<arm::Joints> to = find_variable(variables, operation[1].text());
    if (!to) return fail(to);
    return joint_move(model, from, *to);
  }
  if (operation.is_form("move-to")) return line_to(model, from, operation);
  if (operation.is_form("retract")) {
    const Result<Eigen::Vector3d> out = extension(model, from, "keep-height"_sym);
    return stretched(model, from, -*out, operation[1]);
  }
  if (operation.is_form("extend")) {
    const Result<Eigen::Vector3d> out = extension(model, from, operation[1]);
    if (!out) return fail(out);
    return stretched(model, from, *out, operation[2]);
  }
  if (operation.is_form("do-action")) {
    Result<std::vector<arm::Joints>> waypoints = script_waypoints(model, operation[1].text(), from, variables);
    if (!waypoints) return fail(waypoints);
    return Motion{std::move(*waypoints)};
  }
  return directed(model, operation, from);
}

Result<void> check_room(const arm::ArmModel& model, const std::optional<WorkVolume>& room, const arm::Joints& from,
                        const std::vector<arm::Joints>& waypoints) {
  if (!room) return {};
  bool inside = room->holds(arm::forward(model, from).translation());
  for (const arm::Joints& waypoint : waypoints) {
    const Eigen::Vector3d point = arm::forward(model, waypoint).translation();
    const bool now = room->holds(point);
    const bool last = &waypoint == &waypoints.back();
    if ((inside || last) && !now) {
      return fail("out-of-room",
                  fmt::format("({:.0f} {:.0f} {:.0f}) is out of the arm's room", point.x(), point.y(), point.z()),
                  list("point"_sym, point.x(), point.y(), point.z()));
    }
    inside = inside || now;
  }
  return {};
}

Result<arm::Joints> find_variable(const ArmVariables& variables, std::string_view name) {
  const auto known = variables.find(name);
  if (known != variables.end()) return known->second;
  const std::string nearest = nearest_name(name, std::views::keys(variables));
  return fail("unknown-variable",
              fmt::format("no variable {} was learned{}", name,
                          nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
              Datum::symbol(name));
}

Result<double> amount_in(const Datum& given, double low, double high, std::string_view unit) {
  const double value = given.number();
  if (value >= low && value <= high) return value;
  return fail("out-of-range", fmt::format("{} is not within {:g} to {:g} {}", write(given), low, high, unit), given);
}

Result<double> clamped_amount(const Datum& given, double high, std::string_view unit) {
  const double value = given.number();
  if (value >= 0) return std::min(value, high);
  return fail("out-of-range", fmt::format("{} is not 0 {} or more", write(given), unit), given);
}

Duration longest_time(const arm::ArmModel& model, const arm::Joints& from, const std::vector<arm::Joints>& waypoints,
                      double speed) {
  double seconds = 0;
  arm::Joints at = from;
  for (const arm::Joints& to : waypoints) {
    double slowest = 0;
    for (std::size_t axis = 0; axis < to.size(); ++axis) {
      slowest = std::max(slowest, std::abs(to[axis] - at[axis]) / (model.axes[axis].speed * speed));
    }
    seconds += slowest;
    at = to;
  }
  const double waypoint_s = 0.1;
  seconds = 10 + 3 * seconds + waypoint_s * static_cast<double>(waypoints.size()) / speed;
  return std::chrono::duration_cast<Duration>(std::chrono::duration<double>(seconds));
}

}  // namespace pizarra::robot
