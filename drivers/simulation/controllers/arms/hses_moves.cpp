#include "drivers/simulation/controllers/arms/hses_moves.hpp"

#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/line/octets.hpp"
#include "drivers/simulation/controllers/arms/hses_codes.hpp"

namespace pizarra::simulation {

namespace {

constexpr double order_units_per_deg = 10'000;
constexpr std::size_t axes_in_a_move = 7;
constexpr std::uint32_t whole_speed = 10'000;

// Nothing moves but by this service and attribute.
std::uint16_t wrong_order(const arm::HsesRequest& order) {
  if (order.service != arm::hses::set_all) return arm::hses::undefined_command;
  return order.attribute == 1 ? std::uint16_t{0} : arm::hses::wrong_attribute;
}

// In percent of the axes' speeds, or in mm/s.
bool is_speed(bool by_joints, std::uint32_t speed_class, std::uint32_t speed) {
  if (speed < 1) return false;
  return by_joints ? speed_class == arm::hses::percent && speed <= whole_speed : speed_class == arm::hses::millimetres;
}

}  // namespace

Task<HsesOutcome> hses_move_pulses(MotomanController& controller, arm::HsesRequest request) {
  HsesOutcome outcome;
  line::OctetReader read(request.data, line::ByteOrder::little);
  const std::uint32_t robot = read.u32();
  read.u32();
  const std::uint32_t speed_class = read.u32();
  const std::uint32_t speed = read.u32();
  arm::MotomanPulses target{};
  for (std::size_t axis = 0; axis < axes_in_a_move; ++axis) target[axis] = read.i32();
  read.u32();
  read.u32();
  read.text(36);
  const bool by_joints = request.instance == arm::hses::joint_move;
  outcome.refusal = wrong_order(request);
  if (outcome.refusal != 0) co_return outcome;
  if (!read.whole()) {
    outcome.refusal = arm::hses::wrong_size;
  } else if (robot != 1 || (!by_joints && request.instance != arm::hses::linear_move)) {
    outcome.refusal = arm::hses::wrong_instance;
  } else if (!is_speed(by_joints, speed_class, speed)) {
    outcome.refusal = arm::hses::wrong_speed;
  }
  if (outcome.refusal != 0) co_return outcome;
  Refusal refusal = Refusal::none;
  if (by_joints) {
    refusal = co_await controller.move_joints(target, static_cast<double>(speed) / whole_speed);
  } else {
    refusal = co_await controller.move_straight(controller.pose_of(target), speed / 10.0);
  }
  outcome.refusal = hses_code(refusal);
  co_return outcome;
}

Task<HsesOutcome> hses_move_cartesian(MotomanController& controller, arm::HsesRequest request) {
  HsesOutcome outcome;
  line::OctetReader read(request.data, line::ByteOrder::little);
  const std::uint32_t robot = read.u32();
  read.u32();
  const std::uint32_t speed_class = read.u32();
  const std::uint32_t speed = read.u32();
  const std::uint32_t frame = read.u32();
  arm::MotomanPose target;
  for (double& mm : target.place_mm) mm = read.i32() / arm::um_per_mm;
  for (double& deg : target.angles_deg) deg = read.i32() / order_units_per_deg;
  // The seventh axis, form, tool and user frame, and what is reserved.
  read.text(6 * 4 + 36);
  const bool by_joints = request.instance == arm::hses::joint_move;
  const bool on = request.instance == hses::incremental_move;
  const bool in_tool = on && frame == hses::tool_frame;
  outcome.refusal = wrong_order(request);
  if (outcome.refusal != 0) co_return outcome;
  if (!read.whole()) {
    outcome.refusal = arm::hses::wrong_size;
  } else if (robot != 1 || (!by_joints && !on && request.instance != arm::hses::linear_move)) {
    outcome.refusal = arm::hses::wrong_instance;
  } else if (frame != arm::hses::base_frame && frame != hses::robot_frame && !in_tool) {
    outcome.refusal = arm::hses::wrong_frame;
  } else if (!is_speed(by_joints, speed_class, speed)) {
    outcome.refusal = arm::hses::wrong_speed;
  }
  if (outcome.refusal != 0) co_return outcome;
  if (on) {
    const arm::MotomanPose here = co_await controller.pose();
    target = MotomanController::moved_on(here, target, in_tool);
  }
  Refusal refusal = Refusal::none;
  if (by_joints) {
    refusal = co_await controller.move_joints_to(target, static_cast<double>(speed) / whole_speed);
  } else {
    refusal = co_await controller.move_straight(target, speed / 10.0);
  }
  outcome.refusal = hses_code(refusal);
  co_return outcome;
}

}  // namespace pizarra::simulation
