#include "drivers/simulation/truth.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/simulation/render/visibility.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::simulation {

namespace {

using Eigen::Vector3d;

constexpr double upright_deg = 10;
constexpr double height_slack_mm = 6;
constexpr double overhang_mm = 2;    // a cube whose centre is further beyond the other's edge does not rest on it
constexpr double resting_mm_s = 60;  // faster than this it is still falling
constexpr double half_visible = 0.5;

struct State {
  enum class Kind { table, on, held, carried, loose, gone } kind = Kind::loose;
  DynamicId below = 0;
};

// How far the cube is from standing on one of its faces, degrees.
double tilt_deg(const Pose& pose) {
  const double steepest = pose.linear().row(2).cwiseAbs().maxCoeff();
  return degrees(std::acos(std::min(1.0, steepest)));
}

// The turn of its side faces against the base axes, -45..45 degrees.
double yaw_deg(const Pose& pose) {
  Eigen::Index flattest = 0;
  pose.linear().row(2).cwiseAbs().minCoeff(&flattest);
  const Vector3d side = pose.linear().col(flattest);
  const double angle = degrees(std::atan2(side.y(), side.x()));
  return angle - 90 * std::round(angle / 90);
}

State state_of(const Cell& cell, DynamicId cube) {
  const Physics& physics = cell.physics();
  if (!physics.present(cube)) return {State::Kind::gone};
  if (cell.gripper().held() == cube) return {State::Kind::held};
  if (cell.hand().carried() == cube) return {State::Kind::carried};
  const Pose pose = physics.pose(cube);
  const Vector3d at = pose.translation();
  if (tilt_deg(pose) > upright_deg || physics.velocity_mm_s(cube).norm() > resting_mm_s) return {State::Kind::loose};
  if (std::abs(at.z() - physics.height_mm(cube) / 2) < height_slack_mm) return {State::Kind::table};
  for (DynamicId other = 0; other < physics.dynamics(); ++other) {
    if (other == cube || !physics.present(other)) continue;
    const Vector3d from_other = physics.pose(other).inverse() * at;
    const Vector3d apart = at - physics.pose(other).translation();
    // The other's own axes, whichever of them stands upright, tell how far aside it is.
    Eigen::Index upright = 0;
    physics.pose(other).linear().row(2).cwiseAbs().maxCoeff(&upright);
    bool is_over = true;
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      const double reach_mm = physics.shape(other).size_mm[axis] / 2 + overhang_mm;
      if (axis != upright) is_over = is_over && std::abs(from_other[axis]) < reach_mm;
    }
    const double above_mm = (physics.height_mm(cube) + physics.height_mm(other)) / 2;
    if (std::abs(apart.z() - above_mm) < height_slack_mm && is_over) return {State::Kind::on, other};
  }
  return {State::Kind::loose};
}

Datum to_datum(const Cell& cell, const State& state) {
  switch (state.kind) {
    case State::Kind::table:
      return "table"_sym;
    case State::Kind::on:
      return list("on"_sym, Datum::symbol(cell.name(state.below)));
    case State::Kind::held:
      return "held"_sym;
    case State::Kind::carried:
      return "carried"_sym;
    case State::Kind::loose:
      return "loose"_sym;
    case State::Kind::gone:
      break;
  }
  return "gone"_sym;
}

// The cube's mark that shows best, if any is turned to the eye.
std::optional<MarkView> best_mark(const std::vector<MarkView>& marks, int first_id, int last_id) {
  std::optional<MarkView> best;
  for (const MarkView& mark : marks) {
    if (mark.id < first_id || mark.id > last_id) continue;
    if (!best || mark.all_pixels > best->all_pixels) best = mark;
  }
  return best;
}

double visible(const std::optional<MarkView>& mark) {
  return mark ? static_cast<double>(mark->pixels) / mark->all_pixels : 0.0;
}

Datum facts(const Cell& cell, const std::vector<State>& states) {
  std::vector<Datum> facts{"facts"_sym};
  bool empty = true;
  for (DynamicId cube = 0; cube < states.size(); ++cube) {
    const Datum name = Datum::symbol(cell.name(cube));
    const State& state = states[cube];
    empty = empty && state.kind != State::Kind::held;
    if (cell.is_thing(cube)) continue;
    if (state.kind == State::Kind::on) facts.push_back(list("on"_sym, name, Datum::symbol(cell.name(state.below))));
    if (state.kind == State::Kind::table) facts.push_back(list("on-table"_sym, name));
    if (state.kind == State::Kind::held) facts.push_back(list("holding"_sym, name));
    const bool stands = state.kind == State::Kind::on || state.kind == State::Kind::table;
    const bool covered = std::ranges::any_of(
        states, [&](const State& other) { return other.kind == State::Kind::on && other.below == cube; });
    if (stands && !covered) facts.push_back(list("clear"_sym, name));
  }
  if (empty) facts.push_back(list("arm-empty"_sym));
  return Datum::list(std::move(facts));
}

}  // namespace

Datum truth_of(const Cell& cell, const Eye& left, const Eye& right) {
  const Physics& physics = cell.physics();
  const std::vector<Solid> solids = cell.scene().solids;
  const std::vector<MarkView> on_left = seen_marks(left, solids);
  const std::vector<MarkView> on_right = seen_marks(right, solids);
  const auto visible_in = [](const std::vector<MarkView>& marks, DynamicId cube) {
    return visible(best_mark(marks, mark_id(cube, 0), mark_id(cube, 5)));
  };
  std::vector<State> states;
  for (DynamicId cube = 0; cube < physics.dynamics(); ++cube) states.push_back(state_of(cell, cube));
  std::vector<Datum> out;
  for (DynamicId cube = 0; cube < physics.dynamics(); ++cube) {
    const Pose pose = physics.pose(cube);
    const Vector3d at = pose.translation();
    if (cell.is_thing(cube)) {
      out.push_back(list("thing"_sym, Datum::symbol(cell.name(cube)), at.x(), at.y(), at.z(), yaw_deg(pose),
                         tilt_deg(pose), to_datum(cell, states[cube])));
      continue;
    }
    const double seen = physics.present(cube) ? std::min(visible_in(on_left, cube), visible_in(on_right, cube)) : 0.0;
    out.push_back(list("cube"_sym, Datum::symbol(cell.name(cube)), at.x(), at.y(), at.z(), yaw_deg(pose),
                       tilt_deg(pose), to_datum(cell, states[cube]), seen));
  }
  out.push_back(facts(cell, states));
  return Datum::list(std::move(out));
}

Result<Datum> where_seen(const Cell& cell, const Eye& left, std::string_view name) {
  int first = effector_id;
  int last = effector_id;
  if (!names_agree(name, "end-effector")) {
    const Result<DynamicId> cube = cell.find(name);
    if (!cube) return fail(cube);
    first = mark_id(*cube, 0);
    last = mark_id(*cube, 5);
  }
  const std::optional<MarkView> mark = best_mark(seen_marks(left, cell.scene().solids), first, last);
  if (visible(mark) < half_visible) {
    return fail("not-seen", fmt::format("the mark of {} is not in view", name), Datum::string(name));
  }
  return list(mark->centre_px.x(), mark->centre_px.y());
}

Datum describe_scene(const Cell& cell, const WorldConfig& config, const forms::CameraPose& camera) {
  const TableConfig& table = config.table;
  std::vector<Datum> out;
  out.push_back(list("table"_sym, table.x_low_mm, table.x_high_mm, table.y_low_mm, table.y_high_mm));
  out.push_back(list("camera"_sym, camera.at_mm[0], camera.at_mm[1], camera.at_mm[2], camera.pan_deg, camera.tilt_deg,
                     camera.roll_deg));
  for (DynamicId cube = 0; cube < cell.physics().dynamics(); ++cube) {
    if (cell.is_thing(cube)) continue;
    out.push_back(list("cube"_sym, Datum::symbol(cell.name(cube)), face_mark_name(*cell.marks(cube).front())));
  }
  return Datum::list(std::move(out));
}

}  // namespace pizarra::simulation
