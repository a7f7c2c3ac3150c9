#include "drivers/simulation/render/scene.hpp"

#include <cmath>
#include <vector>

#include "drivers/simulation/gripper_shape.hpp"
#include "drivers/simulation/render/arm_solids.hpp"
#include "drivers/simulation/render/second_lamp.hpp"
#include "drivers/simulation/render/seen_photograph.hpp"
#include "drivers/simulation/render/table_shadow.hpp"

namespace pizarra::simulation {

namespace {

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
constexpr int cylinder_sides = 24;
constexpr double grid_mm = 100;
constexpr double grid_line_mm = 3;

using Eigen::Vector3d;

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
  return make_prism(middle - along, middle + along, radius_mm, radius_mm, cylinder_sides, thing_grey);
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
