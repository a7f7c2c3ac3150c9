#include "drivers/simulation/controllers/arms/hses_emulator.hpp"

#include <cmath>

#include "drivers/arm/angles.hpp"
#include "drivers/simulation/controllers/arms/straight_way.hpp"
#include "drivers/wire/octets.hpp"

namespace pizarra {

namespace {

constexpr std::uint8_t abnormal = 0x1f;
constexpr std::uint16_t wanted_opening = 0;  // variables
constexpr std::uint16_t measured_opening = 1;
constexpr std::uint16_t fingers_move = 2;
constexpr std::uint16_t last_variable = 99;
constexpr double um_per_mm = 1000;
constexpr double units_per_deg = 10'000;
constexpr std::size_t axes_told = 8;
constexpr std::size_t axes_in_a_move = 7;

std::uint16_t code_of(Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      return 0;
    case Refusal::running:
      return hses::operating;
    case Refusal::pendant:
      return hses::not_remote;
    case Refusal::alarm:
      return hses::alarm_occurring;
    case Refusal::emergency:
    case Refusal::servo_off:
      return hses::servo_off;
    case Refusal::pendant_hold:
      return hses::pendant_hold;
    case Refusal::command_hold:
      return hses::command_hold;
    case Refusal::out_of_range:
      return hses::out_of_range;
  }
  return hses::undefined_command;
}

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::llround(value)); }

// The controller's base frame and tool, and the cell's.
ToolPose flange_in_base(const ArmModel& model, const Joints& joints) {
  ToolPose pose = forward(model, joints);
  pose.translation() -= model.tool_mm * pose.linear().col(2);
  pose.translation().z() -= model.height_mm;
  return pose;
}
ToolPose grip_in_cell(const ArmModel& model, ToolPose flange) {
  flange.translation() += model.tool_mm * flange.linear().col(2);
  flange.translation().z() += model.height_mm;
  return flange;
}

std::string position_data(std::uint32_t kind, const std::array<std::int32_t, axes_told>& axes) {
  OctetWriter data(ByteOrder::little);
  data.u32(kind).u32(0).u32(0).u32(0).u32(0);
  for (const std::int32_t axis : axes) data.i32(axis);
  return data.octets();
}

}  // namespace

Task<std::string> HsesEmulator::answer(std::string datagram) {
  const Result<HsesRequest> request = read_hses_request(datagram);
  const bool heard = request && cabinet_.powered();
  if (!heard) co_return std::string();
  const Outcome outcome = co_await carry_out(*request);
  // It may have lost its power meanwhile.
  if (!cabinet_.powered()) co_return std::string();
  HsesReply reply{.id = request->id};
  reply.service = request->service | hses::answered;
  reply.status = outcome.refusal == 0 ? 0 : abnormal;
  reply.added_status = outcome.refusal;
  reply.data = outcome.data;
  co_return write_hses(reply);
}

Task<HsesEmulator::Outcome> HsesEmulator::at_once(Outcome outcome) { co_return outcome; }

Task<HsesEmulator::Outcome> HsesEmulator::carry_out(HsesRequest request) {
  switch (request.command) {
    case hses::status:
      return status();
    case hses::position:
      return position(request.instance);
    case hses::double_integer:
      return variable(std::move(request));
    case hses::move_pulses:
      return move_pulses(std::move(request));
    case hses::move_cartesian:
      return move_cartesian(std::move(request));
    default:
      return at_once(turn(request));
  }
}

Task<HsesEmulator::Outcome> HsesEmulator::status() {
  const ArmReading reading = co_await cabinet_.read();
  const bool pendant = cabinet_.pendant();
  std::uint32_t modes = 1u << 2;
  if (reading.moving) modes |= 1u << 3;
  modes |= pendant ? 1u << 5 : 1u << 6 | 1u << 7;
  std::uint32_t states = 0;
  if (cabinet_.pendant_hold()) states |= 1u << 1;
  if (cabinet_.command_hold()) states |= 1u << 3;
  if (cabinet_.alarm() != 0) states |= 1u << 4;
  if (cabinet_.servo()) states |= 1u << 6;
  Outcome outcome;
  outcome.data = OctetWriter(ByteOrder::little).u32(modes).u32(states).octets();
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::position(std::uint16_t instance) {
  const ArmReading reading = co_await cabinet_.read();
  const ArmModel& model = cabinet_.model();
  std::array<std::int32_t, axes_told> axes{};
  Outcome outcome;
  if (instance == hses::robot_pulses) {
    for (std::size_t axis = 0; axis < model.axes.size(); ++axis) {
      axes[axis] = rounded(reading.joints[axis] * model.axes[axis].pulses_per_turn / 360);
    }
    outcome.data = position_data(0, axes);
  } else if (instance == hses::robot_base) {
    const ToolPose flange = flange_in_base(model, reading.joints);
    const std::array<double, 3> angles = fixed_angles(flange.linear());
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i] = rounded(flange.translation()[static_cast<Eigen::Index>(i)] * um_per_mm);
      axes[i + 3] = rounded(angles[i] * units_per_deg);
    }
    outcome.data = position_data(hses::base_frame, axes);
  } else {
    outcome.refusal = hses::wrong_instance;
  }
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::variable(HsesRequest request) {
  Outcome outcome;
  if (request.instance > last_variable) {
    outcome.refusal = hses::wrong_instance;
    co_return outcome;
  }
  const ArmReading reading = co_await cabinet_.read();
  if (request.service == hses::get_one) {
    std::int32_t value = variables_[request.instance];
    if (request.instance == measured_opening) value = rounded(reading.opening_mm * um_per_mm);
    if (request.instance == fingers_move) value = reading.gripper_moving ? 1 : 0;
    outcome.data = OctetWriter(ByteOrder::little).i32(value).octets();
    co_return outcome;
  }
  OctetReader read(request.data, ByteOrder::little);
  const std::int32_t value = read.i32();
  const bool sound = request.service == hses::set_one && read.whole();
  if (!sound) {
    outcome.refusal = hses::wrong_size;
    co_return outcome;
  }
  variables_[request.instance] = value;
  if (request.instance == wanted_opening) co_await cabinet_.grip(value / um_per_mm);
  co_return outcome;
}

// Switches, resets, and what of an alarm is known.
HsesEmulator::Outcome HsesEmulator::turn(const HsesRequest& request) {
  if (request.command == hses::alarm) {
    const bool code = request.instance == 1 && request.attribute == 1 && request.service == hses::get_one;
    if (!code) return {.refusal = hses::wrong_attribute};
    const auto alarm = static_cast<std::uint32_t>(cabinet_.alarm());
    return {.data = OctetWriter(ByteOrder::little).u32(alarm).octets()};
  }
  OctetReader read(request.data, ByteOrder::little);
  const std::uint32_t wanted = read.u32();
  if (request.command != hses::reset && request.command != hses::power) return {.refusal = hses::undefined_command};
  if (request.attribute != 1 || request.service != hses::set_one) return {.refusal = hses::wrong_attribute};
  if (!read.whole()) return {.refusal = hses::wrong_size};
  if (request.command == hses::reset) {
    if (request.instance == hses::cancel_error) return {};
    if (request.instance != hses::reset_alarm) return {.refusal = hses::wrong_instance};
    return {.refusal = code_of(cabinet_.reset())};
  }
  if (wanted != hses::on && wanted != hses::off) return {.refusal = hses::out_of_range};
  if (request.instance == hses::hold) return {.refusal = code_of(cabinet_.hold(wanted == hses::on))};
  if (request.instance != hses::servo) return {.refusal = hses::wrong_instance};
  const Refusal refusal = cabinet_.servo(wanted == hses::on);
  return {.refusal = refusal == Refusal::emergency ? hses::servo_refused : code_of(refusal)};
}

Task<HsesEmulator::Outcome> HsesEmulator::move_pulses(HsesRequest request) {
  Outcome outcome;
  OctetReader read(request.data, ByteOrder::little);
  const std::uint32_t robot = read.u32();
  read.u32();
  const std::uint32_t speed_class = read.u32();
  const std::uint32_t speed = read.u32();
  const ArmModel& model = cabinet_.model();
  Joints target(model.axes.size());
  for (std::size_t axis = 0; axis < axes_in_a_move; ++axis) {
    const std::int32_t pulses = read.i32();
    if (axis < target.size()) target[axis] = pulses * 360.0 / model.axes[axis].pulses_per_turn;
  }
  read.u32();
  read.u32();
  read.text(36);
  constexpr std::uint32_t whole = 10'000;
  if (!read.whole()) {
    outcome.refusal = hses::wrong_size;
  } else if (robot != 1 || request.instance != hses::joint_move) {
    outcome.refusal = hses::wrong_instance;
  } else if (speed_class != hses::percent || speed < 1 || speed > whole) {
    outcome.refusal = hses::wrong_speed;
  } else {
    std::vector<Joints> waypoints{target};
    const double part = static_cast<double>(speed) / whole;
    const Refusal refusal = co_await cabinet_.move(std::move(waypoints), part);
    outcome.refusal = code_of(refusal);
  }
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::move_cartesian(HsesRequest request) {
  Outcome outcome;
  OctetReader read(request.data, ByteOrder::little);
  const std::uint32_t robot = read.u32();
  read.u32();
  const std::uint32_t speed_class = read.u32();
  const std::uint32_t speed = read.u32();
  const std::uint32_t frame = read.u32();
  Eigen::Vector3d place_mm;
  Eigen::Vector3d angles_deg;
  for (double& mm : place_mm) mm = read.i32() / um_per_mm;
  for (double& deg : angles_deg) deg = read.i32() / units_per_deg;
  // The seventh axis, form, tool and user frame, and what is reserved.
  read.text(6 * 4 + 36);
  if (!read.whole()) {
    outcome.refusal = hses::wrong_size;
  } else if (robot != 1 || request.instance != hses::linear_move) {
    outcome.refusal = hses::wrong_instance;
  } else if (frame != hses::base_frame) {
    outcome.refusal = hses::wrong_frame;
  } else if (speed_class != hses::millimetres || speed < 1) {
    outcome.refusal = hses::wrong_speed;
  }
  if (outcome.refusal != 0) co_return outcome;
  ToolPose flange;
  flange.translation() = place_mm;
  const Eigen::AngleAxisd about_x(radians(angles_deg.x()), Eigen::Vector3d::UnitX());
  flange.linear() = about_z(angles_deg.z()) * about_y(angles_deg.y()) * about_x.toRotationMatrix();
  const ArmReading reading = co_await cabinet_.read();
  const ArmModel& model = cabinet_.model();
  const Result<StraightWay> way = straight_way(model, reading.joints, grip_in_cell(model, flange), speed / 10.0);
  if (!way) {
    outcome.refusal = reading.moving ? hses::operating : hses::out_of_range;
    co_return outcome;
  }
  const Refusal refusal = co_await cabinet_.move(way->waypoints, way->part);
  outcome.refusal = code_of(refusal);
  co_return outcome;
}

Task<void> serve(Executor& executor, HsesEmulator& emulator, DatagramWire& port) {
  constexpr Duration patience = 3600s;
  constexpr Duration retry_pause = 100ms;
  while (true) {
    const Time heard_by = executor.now() + patience;
    Result<std::string> datagram = co_await port.receive(heard_by);
    if (!datagram) {
      if (datagram.error().symbol != "timeout") co_await sleep(executor, retry_pause);
      continue;
    }
    const std::string reply = co_await emulator.answer(std::move(*datagram));
    // What nobody takes is lost, as on any line.
    if (!reply.empty()) static_cast<void>(port.send(reply));
  }
}

}  // namespace pizarra
