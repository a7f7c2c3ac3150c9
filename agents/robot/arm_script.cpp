#include "agents/robot/arm_script.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "agents/robot/tool_path.hpp"
#include "lisp/nearest.hpp"
#include "lisp/plain_text.hpp"
#include "lisp/reader.hpp"

namespace pizarra::robot {

namespace {

using Eigen::Vector3d;

constexpr ReadLimits limits{.bytes = 4096, .depth = 4, .elements = 512};
constexpr std::size_t max_forms = 32;
constexpr double max_radius_mm = 1000;
constexpr double sagitta_mm = 0.05;

// `CIRCLE p1, p2` as `(CIRCLE p1  p2)`, line by line; LISP stays as it is.
std::string as_forms(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos || text[first] == '(' || text[first] == ';') return std::string(text);
  std::string out;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    std::string line(text.substr(0, end));
    std::ranges::replace(line, ',', ' ');
    const bool blank = line.find_first_not_of(" \t\r") == std::string::npos;
    out += blank ? "\n" : "(" + line + ")\n";
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return out;
}

class Script {
 public:
  Script(const arm::ArmModel& model, const arm::Joints& from, const ArmVariables& variables)
      : model_(model), variables_(variables), path_(model, from) {}

  Result<void> run(const Datum& form);
  const std::vector<arm::Joints>& waypoints() const { return path_.waypoints(); }

 private:
  Result<Vector3d> point(const Datum& given) const;
  Result<void> line(const Vector3d& to) { return path_.reach_by_line(to); }
  Result<void> move(std::span<const Datum> arguments);
  Result<void> path(std::span<const Datum> arguments);
  Result<void> track(std::span<const Datum> arguments);
  Result<void> around(std::span<const Datum> arguments, bool whole);

  const arm::ArmModel& model_;
  const ArmVariables& variables_;
  ToolPath path_;
};

Result<void> Script::run(const Datum& form) {
  const std::string verb = lowered(form.head());
  if (verb.empty()) return fail("bad-action", "an action is a form such as (move X Y Z)", form);
  const std::span<const Datum> arguments = form.items().subspan(1);
  if (verb == "move") return move(arguments);
  if (verb == "path") return path(arguments);
  if (verb == "track") return track(arguments);
  if (verb == "circle") return around(arguments, true);
  if (verb == "arc") return around(arguments, false);
  constexpr std::string_view known[] = {"move", "path", "circle", "arc", "track"};
  const std::string nearest = nearest_name(verb, known);
  return fail("bad-action",
              fmt::format("{} is no action; {}", form.head(),
                          nearest.empty() ? "there are move, path, circle, arc and track"
                                          : fmt::format("did you mean {}?", nearest)),
              form);
}

Result<Vector3d> Script::point(const Datum& given) const {
  if (given.is_symbol()) {
    const Result<arm::Joints> joints = find_variable(variables_, given.text());
    if (!joints) return fail(joints);
    return Vector3d(arm::forward(model_, *joints).translation());
  }
  const bool numbers = given.size() == 3 && std::ranges::all_of(given.items(), &Datum::is_number);
  if (!numbers) return fail("bad-action", "a point is a learned variable or (X Y Z)", given);
  return Vector3d(given[0].number(), given[1].number(), given[2].number());
}

Result<void> Script::move(std::span<const Datum> arguments) {
  if (arguments.size() != 1 && arguments.size() != 3) return fail("bad-action", "it is (move X Y Z) or (move POINT)");
  const Datum given = arguments.size() == 1 ? arguments[0] : Datum::list({arguments.begin(), arguments.end()});
  const Result<Vector3d> to = point(given);
  if (!to) return fail(to);
  return line(*to);
}

Result<void> Script::path(std::span<const Datum> arguments) {
  if (arguments.empty()) return fail("bad-action", "it is (path VARIABLE ...)");
  for (const Datum& name : arguments) {
    if (!name.is_symbol()) return fail("bad-action", "a path takes names of learned variables alone", name);
    const Result<arm::Joints> joints = find_variable(variables_, name.text());
    if (!joints) return fail(joints);
    const Result<void> moved = path_.joints_to(*joints);
    if (!moved) return moved;
  }
  return {};
}

Result<void> Script::track(std::span<const Datum> arguments) {
  if (arguments.size() != 1 || !arguments[0].is_number()) return fail("bad-action", "it is (track MM)");
  const std::optional<std::size_t> axis = model_.axis_of(arm::Role::track);
  if (!axis) return fail("no-such-axis", fmt::format("the arm {} has no track", model_.type));
  arm::Joints joints = path_.joints();
  joints[*axis] = arguments[0].number();
  return path_.joints_to(joints);
}

Result<void> Script::around(std::span<const Datum> arguments, bool whole) {
  if (arguments.size() != 3) return fail("bad-action", "a circle and an arc take three points");
  Vector3d points[3];
  for (std::size_t i = 0; i < 3; ++i) {
    const Result<Vector3d> given = point(arguments[i]);
    if (!given) return fail(given);
    points[i] = *given;
  }
  // The circumcentre of the triangle.
  const Vector3d u = points[1] - points[0];
  const Vector3d v = points[2] - points[0];
  const Vector3d normal = u.cross(v);
  const double area = normal.squaredNorm();
  // The thinnest triangle taken: about 0.001 of its longest side high.
  if (!(normal.norm() > 1e-3 * std::max(u.squaredNorm(), v.squaredNorm())) || !(area < 1e18)) {
    return fail("bad-action", "three points on one line, or two in one place, make no circle");
  }
  const Vector3d to_centre = (u.squaredNorm() * v.cross(normal) + v.squaredNorm() * normal.cross(u)) / (2 * area);
  const double radius = to_centre.norm();
  if (radius > max_radius_mm) {
    return fail("bad-action", fmt::format("a radius of {:.0f} mm is beyond {:g}", radius, max_radius_mm));
  }
  const Vector3d centre = points[0] + to_centre;
  const Vector3d x = -to_centre / radius;
  const Vector3d y = normal.normalized().cross(x);
  // From P1 by way of P2 to P3 is the positive sense about u x v.
  const Vector3d last = points[2] - centre;
  double sweep = std::atan2(last.dot(y), last.dot(x));
  if (sweep <= 0) sweep += 2 * std::numbers::pi;
  if (whole) sweep = 2 * std::numbers::pi;

  const Result<void> begun = line(points[0]);
  if (!begun) return begun;
  // Chords stay within `sagitta_mm` of the circle.
  const double widest = 2 * std::acos(1 - std::min(1.0, sagitta_mm / radius));
  const double steps = std::ceil(sweep / std::min(widest, ToolPath::step_mm / radius));
  for (double step = 1; step <= steps; ++step) {
    const double angle = sweep * step / steps;
    const Result<void> moved = line(centre + radius * (std::cos(angle) * x + std::sin(angle) * y));
    if (!moved) return moved;
  }
  return {};
}

}  // namespace

Result<std::vector<arm::Joints>> script_waypoints(const arm::ArmModel& model, std::string_view text,
                                                  const arm::Joints& from, const ArmVariables& variables) {
  const Result<Source> source = read_source(as_forms(text), "do-action", limits);
  if (!source) return fail(source);
  const std::size_t forms = source->data().size();
  if (forms == 0) return fail("bad-action", "there is nothing to do");
  if (forms > max_forms) return fail("bad-action", fmt::format("an action has at most {} forms", max_forms));
  Script script(model, from, variables);
  for (std::size_t i = 0; i < forms; ++i) {
    const Result<void> done = script.run(source->data()[i]);
    if (done) continue;
    Failure failure = source->failure_at({i}, done.error().symbol, done.error().sentence);
    failure.subject = done.error().subject;
    return fail(std::move(failure));
  }
  return script.waypoints();
}

}  // namespace pizarra::robot
