#include "drivers/simulation/physics/physical_cell.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>

#include "drivers/arm/kinematics.hpp"
#include "lisp/numbers.hpp"
#include "lisp/plain_name.hpp"

namespace pizarra::simulation {

namespace {

using Eigen::Vector3d;

constexpr double step_s = 1.0 / steps_per_second;
constexpr double press_limit_n = 15;  // on what is held
constexpr int press_steps = 3;        // a jerk of the arm itself is over sooner
constexpr double press_limit_mm = 3;  // into a cube that cannot give way
constexpr double table_limit_mm = -0.5;
constexpr double gone_below_mm = -150;

Pose standing(double x_mm, double y_mm, double z_mm, double yaw_deg) {
  Pose pose = Pose::Identity();
  pose.translation() = Vector3d(x_mm, y_mm, z_mm);
  pose.linear() = Eigen::AngleAxisd(radians(yaw_deg), Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

// The lowest corner of the box that lies over the table.
double lowest_corner(const Pose& tool, const Box& box, double aside_mm, const TableConfig& table) {
  double lowest = 1e9;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3d sign((corner & 1) != 0 ? 1 : -1, (corner & 2) != 0 ? 1 : -1, (corner & 4) != 0 ? 1 : -1);
    const Vector3d at = tool * (box.centre_mm + Vector3d(0, aside_mm, 0) + box.half_mm.cwiseProduct(sign));
    const bool over =
        at.x() > table.x_low_mm && at.x() < table.x_high_mm && at.y() > table.y_low_mm && at.y() < table.y_high_mm;
    if (over) lowest = std::min(lowest, at.z());
  }
  return lowest;
}

}  // namespace

bool names_agree(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

Cell::Cell(const WorldConfig& config)
    : config_(config),
      physics_(config.table),
      arm_(config.arm, config.start_joints.value_or(config.arm.ready)),
      gripper_(physics_),
      fingers_(physics_, gripper_, Random(config.seed).split("fingers")),
      hand_(physics_, gripper_) {
  place_cubes();
  place_things();
}

void Cell::place_cubes() {
  for (const CubeConfig& cube : config_.cubes) {
    const double edge_mm = config_.edge_mm(cube);
    Pose pose = standing(cube.x_mm, cube.y_mm, edge_mm / 2, cube.yaw_deg);
    if (!cube.on.empty()) {
      const Result<DynamicId> below = find(cube.on);
      const Vector3d under = physics_.pose(*below).translation();
      const double above_mm = (physics_.height_mm(*below) + edge_mm) / 2;
      pose = standing(under.x(), under.y(), under.z() + above_mm, cube.yaw_deg);
    }
    physics_.add_dynamic(pose, cube_shape(edge_mm));
    cubes_.push_back({cube.name, cube.marks()});
  }
}

void Cell::place_things() {
  for (const ThingConfig& thing : config_.things) {
    physics_.add_dynamic(standing(thing.x_mm, thing.y_mm, thing.shape.size_mm.z() / 2, thing.yaw_deg), thing.shape);
    cubes_.push_back({thing.name, {}});
  }
}

Pose Cell::tool() const { return arm::forward(config_.arm, arm_.joints()); }

void Cell::step() {
  hand_.step(step_s);
  gripper_.step(tool(), step_s);
  fingers_.step(step_s);
  physics_.step();
  if (arm_.moving() && !was_moving_) {
    before_ = load();
    lowest_before_mm_ = before_.lowest_mm;
    pressing_steps_ = 0;
  }
  was_moving_ = arm_.moving();
  arm_.step(step_s);
  if (was_moving_) protect();
  for (DynamicId cube = 0; cube < physics_.dynamics(); ++cube) {
    const bool fell = physics_.present(cube) && physics_.pose(cube).translation().z() < gone_below_mm;
    if (!fell) continue;
    if (gripper_.held() == cube) gripper_.lose();
    physics_.take_away(cube);
  }
}

Cell::Load Cell::load() const {
  const Pose now = tool();
  const double aside = (gripper_.opening_mm() + gripper_shape::finger_thickness_mm) / 2;
  const double lowest = std::min({lowest_corner(now, gripper_shape::finger, aside, config_.table),
                                  lowest_corner(now, gripper_shape::finger, -aside, config_.table),
                                  lowest_corner(now, gripper_shape::palm, 0, config_.table)});
  return {physics_.hold_force_n(), gripper_.press_depth_mm(), lowest};
}

void Cell::protect() {
  const Load now = load();
  const bool pressing = now.force_n > std::max(press_limit_n, 1.3 * before_.force_n);
  pressing_steps_ = pressing ? pressing_steps_ + 1 : 0;
  const bool pressed = pressing_steps_ >= press_steps;
  const bool jammed = now.depth_mm > std::max(press_limit_mm, before_.depth_mm + 0.5);
  const bool in_table = now.lowest_mm < table_limit_mm && now.lowest_mm < lowest_before_mm_;
  lowest_before_mm_ = now.lowest_mm;
  if (pressed || jammed || in_table) arm_.halt();
}

bool Cell::at_rest() const {
  return !arm_.moving() && !was_moving_ && !gripper_.moving() && !hand_.busy() && !fingers_.is_about_to_slip() &&
         physics_.asleep();
}

Snapshot Cell::snapshot() const {
  Snapshot snapshot{
      .cubes = {}, .joints = arm_.joints(), .opening_mm = gripper_.opening_mm(), .fist_mm = hand_.fist_mm()};
  for (DynamicId cube = 0; cube < physics_.dynamics(); ++cube) {
    snapshot.cubes.push_back({physics_.pose(cube), cubes_[cube].marks, physics_.present(cube), physics_.shape(cube)});
  }
  return snapshot;
}

Result<DynamicId> Cell::find(std::string_view name) const {
  for (DynamicId cube = 0; cube < cubes_.size(); ++cube) {
    if (names_agree(cubes_[cube].name, name)) return cube;
  }
  return fail("unknown-object", fmt::format("no cube is called {}", name), Datum::string(name));
}

Result<DynamicId> Cell::prepare(std::string_view name, const FaceMark& mark) {
  const Result<DynamicId> known = find(name);
  if (known) {
    if (physics_.present(*known)) return fail("bad-request", fmt::format("{} is in the cell already", name));
    return known;
  }
  if (cubes_.size() == max_cubes + config_.things.size())
    return fail("bad-request", fmt::format("a cell has at most {} cubes", max_cubes));
  if (!is_plain_name(name)) return fail("bad-request", fmt::format("{} is no name for an object", name));
  cubes_.push_back({std::string(name), on_each_face(mark)});
  const DynamicId cube = physics_.add_dynamic(standing(0, 0, 0, 0), cube_shape(config_.cube_mm));
  physics_.take_away(cube);
  return cube;
}

}  // namespace pizarra::simulation
