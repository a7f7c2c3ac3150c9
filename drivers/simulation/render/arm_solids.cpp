#include "drivers/simulation/render/arm_solids.hpp"

namespace pizarra::simulation {

namespace {

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

}  // namespace

void add_pedestal(std::vector<Solid>& solids, const arm::ArmModel& arm, const Vector3d& foot) {
  if (arm.build == arm::Build::gantry) return;
  const double top = arm.height_mm - pedestal_below_axis_2_mm;
  solids.push_back(make_prism(foot, foot + Vector3d(0, 0, 24), 112, 112, foot_sides, joint_paint));
  solids.push_back(
      make_prism(foot + Vector3d(0, 0, 24), foot + Vector3d(0, 0, top), 92, 80, foot_sides, pedestal_grey));
}

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

}  // namespace pizarra::simulation
