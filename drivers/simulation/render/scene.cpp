#include "drivers/simulation/render/scene.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "drivers/simulation/gripper_shape.hpp"
#include "drivers/simulation/render/convex.hpp"
#include "drivers/simulation/render/second_lamp.hpp"
#include "drivers/simulation/render/seen_photograph.hpp"

namespace pizarra::simulation {

namespace {

using Eigen::Vector2d;
const Colour cube_white(238, 242, 244);
const Colour thing_grey(150, 160, 156);
const Colour mark_black(30, 28, 28);
const Colour palm_paint(104, 94, 88);
const Colour finger_steel(178, 174, 170);
const Colour plate_black(44, 40, 38);
const Colour plate_white(250, 250, 250);
const Colour table_top(132, 164, 190);
const Colour table_line(118, 150, 176);
const Colour skin(150, 176, 222);
const Colour sleeve(150, 96, 70);

constexpr int round_sides = 14;
constexpr double grid_mm = 100;
constexpr double grid_line_mm = 3;

using Eigen::Vector3d;

const Colour arm_paint(62, 138, 232);
const Colour joint_paint(92, 84, 78);
const Colour pedestal_grey(118, 112, 108);

constexpr int limb_sides = 14;
constexpr int foot_sides = 24;
constexpr double pedestal_below_axis_2_mm = 110;

void add_turret(std::vector<Solid>& solids, const arm::ArmModel& arm, const Vector3d& foot, const Vector3d& ahead) {
  Eigen::Isometry3d turret = Eigen::Isometry3d::Identity();
  turret.linear() << ahead, Vector3d::UnitZ().cross(ahead), Vector3d::UnitZ();
  turret.translation() = foot;
  solids.push_back(make_box(turret, {30, 0, arm.height_mm - 55}, {75, 42, 55}, arm_paint));
}

// From joint to joint, less what the joints themselves take up.
void add_link(std::vector<Solid>& solids, const Vector3d& from, const Vector3d& to, double from_mm, double to_mm) {
  const Vector3d along = to - from;
  if (along.norm() < from_mm + to_mm) return;
  const Vector3d unit = along.normalized();
  solids.push_back(
      make_prism(from + unit * from_mm, to - unit * (to_mm - 6), from_mm - 4, to_mm - 4, limb_sides, arm_paint));
}

void add_joint(std::vector<Solid>& solids, const Vector3d& at, const Vector3d& axis, double half_length_mm,
               double radius_mm) {
  solids.push_back(make_prism(at - axis * half_length_mm, at + axis * half_length_mm, radius_mm, radius_mm, limb_sides,
                              joint_paint));
}

// The solid under axis 1, `foot_mm` being where axis 1 meets the table. A gantry has none.
void add_pedestal(std::vector<Solid>& solids, const arm::ArmModel& arm, const Vector3d& foot) {
  if (arm.build == arm::Build::gantry) return;
  const double top = arm.height_mm - pedestal_below_axis_2_mm;
  solids.push_back(make_prism(foot, foot + Vector3d(0, 0, 24), 112, 112, foot_sides, joint_paint));
  solids.push_back(
      make_prism(foot + Vector3d(0, 0, 24), foot + Vector3d(0, 0, top), 92, 80, foot_sides, pedestal_grey));
}

// All that moves with the arm's axes, up to the flange; the pedestal too, where a track carries it.
void add_arm(std::vector<Solid>& solids, const arm::ArmModel& arm, const arm::Joints& joints) {
  const std::vector<Vector3d> points = arm::skeleton(arm, joints);
  const Vector3d ahead = arm::stretch_of(arm, joints).ahead;
  const Vector3d& wrist = points[points.size() - 2];
  const Vector3d& flange = points.back();
  Vector3d side = Vector3d::UnitZ().cross(ahead);
  if (arm.build != arm::Build::gantry) {
    if (arm.axis_of(arm::Role::track)) add_pedestal(solids, arm, points.front());
    add_turret(solids, arm, points.front(), ahead);
  }
  const bool level = arm.build == arm::Build::scara || arm.build == arm::Build::gantry;
  if (level) side = Vector3d::UnitZ();
  double radius_mm = 46;
  for (std::size_t i = arm.build == arm::Build::gantry ? 0 : 1; i + 2 < points.size(); ++i) {
    add_joint(solids, points[i], side, radius_mm + 12, radius_mm);
    add_link(solids, points[i], points[i + 1], radius_mm, radius_mm - 6);
    radius_mm -= 6;
  }
  add_joint(solids, wrist, side, 38, 30);
  const Vector3d down = flange - wrist;
  if (down.norm() > 30) {
    solids.push_back(make_prism(wrist + down.normalized() * 30, flange, 28, 28, limb_sides, pedestal_grey));
  }
}

Solid table_solid(const WorldConfig& config) {
  const TableConfig& table = config.table;
  const Vector3d low(table.x_low_mm, table.y_low_mm, -table.thickness_mm);
  const Vector3d high(table.x_high_mm, table.y_high_mm, 0);
  Solid solid = make_box(Eigen::Isometry3d::Identity(), (low + high) / 2, (high - low) / 2, table_top);
  Face& top = solid.faces[4];
  if (config.table_picture) {
    top.photograph = over_the_table(config);
    top.photograph->light = lit(Colour::Ones(), top.normal).x();
    return solid;
  }
  Decal lines{{}, lit(table_line, top.normal), 0};
  const auto line = [&](double x0, double y0, double x1, double y1) {
    lines.parts.push_back({{x0, y0, 0}, {x1, y0, 0}, {x1, y1, 0}, {x0, y1, 0}});
  };
  for (double y = std::ceil(low.y() / grid_mm) * grid_mm; y <= high.y(); y += grid_mm) {
    line(low.x(), y - grid_line_mm / 2, high.x(), y + grid_line_mm / 2);
  }
  for (double x = std::ceil(low.x() / grid_mm) * grid_mm; x <= high.x(); x += grid_mm) {
    line(x - grid_line_mm / 2, low.y(), x + grid_line_mm / 2, high.y());
  }
  top.decals.push_back(std::move(lines));
  return solid;
}

Solid cylinder_solid(const Snapshot::Cube& body) {
  const Vector3d along = body.pose.linear().col(2) * (body.shape.size_mm.z() / 2);
  const double radius_mm = body.shape.size_mm.x() / 2;
  const Vector3d middle = body.pose.translation();
  return make_prism(middle - along, middle + along, radius_mm, radius_mm, foot_sides, thing_grey);
}

Solid cube_solid(const Snapshot::Cube& cube, std::size_t number) {
  if (cube.shape.is_round) return cylinder_solid(cube);
  const bool is_marked = cube.marks.front().has_value();
  Solid solid = make_box(cube.pose, Vector3d::Zero(), cube.shape.size_mm / 2, is_marked ? cube_white : thing_grey);
  const double edge_mm = cube.shape.size_mm.x();
  for (int side = 0; side < 6; ++side) {
    const std::optional<FaceMark>& mark = cube.marks[static_cast<std::size_t>(side)];
    if (!mark) continue;
    Face& face = solid.faces[static_cast<std::size_t>(side)];
    const Vector3d centre = cube.pose.translation() + face.normal * (edge_mm / 2);
    const Vector3d up = side < 4 ? cube.pose.linear().col(2) : Vector3d(-cube.pose.linear().col(0));
    const int id = mark_id(number, side);
    if (const auto* tag = std::get_if<TagMark>(&*mark)) {
      paint_tag(face, centre, up, tag->print, tag_part_of_edge * edge_mm, mark_black, id);
    } else {
      paint_mark(face, centre, up, std::get<Mark>(*mark), edge_mm / marked_cube_mm, mark_black, id);
    }
  }
  return solid;
}

void add_gripper(std::vector<Solid>& solids, const Eigen::Isometry3d& tool, double opening_mm) {
  using namespace gripper_shape;
  solids.push_back(make_box(tool, palm.centre_mm, palm.half_mm, palm_paint));
  Solid marked = make_box(tool, plate.centre_mm, plate.half_mm, plate_black);
  paint_mark(marked.faces[0], tool * mark, -tool.linear().col(2), Mark::triangle, 1, plate_white, effector_id);
  solids.push_back(std::move(marked));
  const double aside = (opening_mm + finger_thickness_mm) / 2;
  for (const double y : {-aside, aside}) {
    solids.push_back(make_box(tool, finger.centre_mm + Vector3d(0, y, 0), finger.half_mm, finger_steel));
  }
}

void add_fist(std::vector<Solid>& solids, const Vector3d& at) {
  const Vector3d out = Vector3d(-0.35, at.y() < 0 ? -0.35 : 0.35, 0.85).normalized();
  solids.push_back(make_prism(at - out * 24, at + out * 22, 20, 27, round_sides, skin));
  solids.push_back(make_prism(at + out * 22, at + out * 110, 20, 25, round_sides, skin));
  solids.push_back(make_prism(at + out * 110, at + out * 480, 33, 44, round_sides, sleeve));
}

Points lying_on_table(const Polygon& polygon) {
  Points out;
  for (const Vector2d& point : polygon) out.emplace_back(point.x(), point.y(), 0);
  return out;
}

// Where the solid keeps a lamp high above the table from shining; none beside the table.
void add_shadow(std::vector<Points>& shadows, const Solid& solid, const TableConfig& table) {
  const Vector3d light = (lamp() + Vector3d(0, 0, 1.2)).normalized();
  std::vector<Vector2d> points;
  for (const Vector3d& vertex : solid.vertices) {
    const double height = std::max(0.0, vertex.z());
    const Vector2d on = vertex.head<2>() - light.head<2>() * (height / light.z());
    points.emplace_back(std::clamp(on.x(), table.x_low_mm, table.x_high_mm),
                        std::clamp(on.y(), table.y_low_mm, table.y_high_mm));
  }
  Points hull = lying_on_table(convex_hull(std::move(points)));
  if (hull.size() > 2) shadows.push_back(std::move(hull));
}

// Its shadows fall on the table and on cubes: those on the arm's round limbs would be many and narrow.
void light_by(const LampConfig& lamp, const TableConfig& table, std::size_t cubes, Scene& scene) {
  add_light(lamp, scene.solids);
  add_shadows(lamp, scene.solids, cubes);
  std::vector<const Solid*> casters;
  for (const Solid& solid : scene.solids) casters.push_back(&solid);
  const Points border = {{table.x_low_mm, table.y_low_mm, 0},
                         {table.x_high_mm, table.y_low_mm, 0},
                         {table.x_high_mm, table.y_high_mm, 0},
                         {table.x_low_mm, table.y_high_mm, 0}};
  const Vector3d middle = (border[0] + border[2]) / 2;
  scene.hard_shadows = shadows_on(lamp, border, Vector3d::UnitZ(), casters);
  scene.hard_shadow_dark = static_cast<float>(part_in_shadow(lamp, middle, Vector3d::UnitZ()));
}

}  // namespace

std::vector<Solid> still_solids(const WorldConfig& config) {
  std::vector<Solid> solids;
  solids.push_back(table_solid(config));
  if (!config.arm.axis_of(arm::Role::track)) add_pedestal(solids, config.arm, Vector3d::Zero());
  if (config.second_lamp) add_light(*config.second_lamp, solids);
  return solids;
}

Scene moving_scene(const WorldConfig& config, const Snapshot& snapshot) {
  Scene scene;
  for (std::size_t i = 0; i < snapshot.cubes.size(); ++i) {
    if (!snapshot.cubes[i].present) continue;
    scene.solids.push_back(cube_solid(snapshot.cubes[i], i));
    add_shadow(scene.shadows, scene.solids.back(), config.table);
  }
  const Eigen::Isometry3d tool = arm::forward(config.arm, snapshot.joints);
  const std::size_t gripper = scene.solids.size();
  add_gripper(scene.solids, tool, snapshot.opening_mm);
  for (std::size_t i = gripper; i < scene.solids.size(); ++i) {
    add_shadow(scene.shadows, scene.solids[i], config.table);
  }
  add_arm(scene.solids, config.arm, snapshot.joints);
  if (snapshot.fist_mm) add_fist(scene.solids, *snapshot.fist_mm);
  if (config.second_lamp) light_by(*config.second_lamp, config.table, gripper, scene);
  return scene;
}

}  // namespace pizarra::simulation
