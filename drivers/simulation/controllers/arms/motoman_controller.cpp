#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

#include <cmath>

#include "drivers/arm/angles.hpp"
#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/simulation/controllers/arms/straight_way.hpp"

namespace pizarra::simulation {

namespace {

constexpr int wanted_opening = 0;  // variables
constexpr int measured_opening = 1;
constexpr int fingers_move = 2;

// The controller's base frame and tool, and the cell's.
arm::ToolPose flange_in_base(const arm::ArmModel& model, const arm::Joints& joints) {
  arm::ToolPose pose = arm::forward(model, joints);
  pose.translation() -= model.tool_mm * pose.linear().col(2);
  pose.translation().z() -= model.height_mm;
  return pose;
}

arm::ToolPose transform_of(const arm::MotomanPose& pose) {
  arm::ToolPose flange;
  for (std::size_t i = 0; i < 3; ++i) flange.translation()[static_cast<Eigen::Index>(i)] = pose.place_mm[i];
  const auto& [rx, ry, rz] = pose.angles_deg;
  const Eigen::AngleAxisd about_x(radians(rx), Eigen::Vector3d::UnitX());
  flange.linear() = arm::about_z(rz) * arm::about_y(ry) * about_x.toRotationMatrix();
  return flange;
}

arm::MotomanPose numbers_of(const arm::ToolPose& flange) {
  arm::MotomanPose pose;
  pose.angles_deg = arm::fixed_angles(flange.linear());
  for (std::size_t i = 0; i < 3; ++i) pose.place_mm[i] = flange.translation()[static_cast<Eigen::Index>(i)];
  return pose;
}

arm::Joints joints_of(const arm::ArmModel& model, const arm::MotomanPulses& pulses) {
  arm::Joints joints(model.axes.size());
  for (std::size_t axis = 0; axis < joints.size(); ++axis) {
    joints[axis] = pulses[axis] * 360.0 / model.axes[axis].pulses_per_turn;
  }
  return joints;
}

arm::ToolPose grip_in_cell(const arm::ArmModel& model, const arm::MotomanPose& target) {
  arm::ToolPose flange = transform_of(target);
  flange.translation() += model.tool_mm * flange.linear().col(2);
  flange.translation().z() += model.height_mm;
  return flange;
}

}  // namespace

std::uint16_t motoman_code(Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      return 0;
    case Refusal::running:
      return arm::motoman::operating;
    case Refusal::pendant:
      return arm::motoman::not_remote;
    case Refusal::alarm:
      return arm::motoman::alarm_occurring;
    case Refusal::emergency:
    case Refusal::servo_off:
      return arm::motoman::servo_off;
    case Refusal::pendant_hold:
      return arm::motoman::pendant_hold;
    case Refusal::command_hold:
      return arm::motoman::command_hold;
    case Refusal::out_of_range:
      return arm::motoman::out_of_range;
  }
  return arm::motoman::unknown_command;
}

Task<MotomanController::Words> MotomanController::status() {
  const arm::ArmReading reading = co_await cabinet_.read();
  const bool pendant = cabinet_.pendant();
  std::uint32_t modes = 1u << (cycle_ - 1);
  if (reading.moving) modes |= 1u << 3;
  modes |= pendant ? 1u << 5 : 1u << 6 | 1u << 7;
  std::uint32_t states = 0;
  if (cabinet_.pendant_hold()) states |= 1u << 1;
  if (cabinet_.command_hold()) states |= 1u << 3;
  if (cabinet_.alarm() != 0) states |= 1u << 4;
  if (cabinet_.servo()) states |= 1u << 6;
  Words words{modes, states};
  co_return words;
}

Task<arm::MotomanPulses> MotomanController::pulses() {
  const arm::ArmReading reading = co_await cabinet_.read();
  const arm::ArmModel& model = cabinet_.model();
  arm::MotomanPulses pulses{};
  for (std::size_t axis = 0; axis < model.axes.size(); ++axis) {
    const double count = reading.joints[axis] * model.axes[axis].pulses_per_turn / 360;
    pulses[axis] = static_cast<std::int32_t>(std::llround(count));
  }
  co_return pulses;
}

Task<arm::MotomanPose> MotomanController::pose() {
  const arm::ArmReading reading = co_await cabinet_.read();
  co_return numbers_of(flange_in_base(cabinet_.model(), reading.joints));
}

Task<Refusal> MotomanController::move_joints(arm::MotomanPulses target, double part) {
  std::vector<arm::Joints> waypoints;
  waypoints.push_back(joints_of(cabinet_.model(), target));
  co_return co_await cabinet_.move(std::move(waypoints), part);
}

Task<Refusal> MotomanController::move_straight(arm::MotomanPose target, double mm_s) {
  const arm::ArmReading reading = co_await cabinet_.read();
  const arm::ArmModel& model = cabinet_.model();
  const Result<StraightWay> way = straight_way(model, reading.joints, grip_in_cell(model, target), mm_s);
  if (!way) co_return reading.moving ? Refusal::running : Refusal::out_of_range;
  co_return co_await cabinet_.move(way->waypoints, way->part);
}

Task<Refusal> MotomanController::move_joints_to(arm::MotomanPose target, double part) {
  const arm::ArmReading reading = co_await cabinet_.read();
  const arm::ArmModel& model = cabinet_.model();
  const Result<arm::Joints> joints = arm::inverse(model, grip_in_cell(model, target), reading.joints);
  if (!joints) co_return Refusal::out_of_range;
  std::vector<arm::Joints> waypoints;
  waypoints.push_back(*joints);
  co_return co_await cabinet_.move(std::move(waypoints), part);
}

arm::MotomanPose MotomanController::pose_of(const arm::MotomanPulses& pulses) const {
  return numbers_of(flange_in_base(cabinet_.model(), joints_of(cabinet_.model(), pulses)));
}

arm::MotomanPose MotomanController::moved_on(const arm::MotomanPose& from, const arm::MotomanPose& by, bool in_tool) {
  const arm::ToolPose here = transform_of(from);
  const arm::ToolPose step = transform_of(by);
  if (in_tool) return numbers_of(here * step);
  arm::ToolPose there = here;
  there.translation() += step.translation();
  there.linear() = step.linear() * here.linear();
  return numbers_of(there);
}

bool MotomanController::set_cycle(std::uint32_t cycle) {
  if (cycle < 1 || cycle > 3) return false;
  cycle_ = cycle;
  return true;
}

Task<std::int32_t> MotomanController::variable(int number) {
  const arm::ArmReading reading = co_await cabinet_.read();
  if (number == measured_opening)
    co_return static_cast<std::int32_t>(std::llround(reading.opening_mm * arm::um_per_mm));
  if (number == fingers_move) co_return reading.gripper_moving ? 1 : 0;
  co_return variables_[number];
}

Task<Refusal> MotomanController::set_variable(int number, std::int32_t value) {
  Refusal refusal = Refusal::none;
  if (number == wanted_opening) refusal = co_await cabinet_.grip(value / arm::um_per_mm);
  if (refusal == Refusal::none) variables_[number] = value;
  co_return refusal;
}

}  // namespace pizarra::simulation
