#include "drivers/simulation/controllers/arms/hses_emulator.hpp"

#include <cmath>

#include "drivers/arm/motoman/motoman_codes.hpp"
#include "drivers/line/octets.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::uint8_t abnormal = 0x1f;
constexpr double units_per_deg = 10'000;
constexpr std::size_t axes_in_a_move = 7;

std::uint16_t code_of(Refusal refusal) {
  return refusal == Refusal::out_of_range ? arm::hses::out_of_range : motoman_code(refusal);
}

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::llround(value)); }

std::string position_data(std::uint32_t kind, const arm::MotomanPulses& axes) {
  line::OctetWriter data(line::ByteOrder::little);
  data.u32(kind).u32(0).u32(0).u32(0).u32(0);
  for (const std::int32_t axis : axes) data.i32(axis);
  return data.octets();
}

}  // namespace

Task<std::string> HsesEmulator::answer(std::string datagram) {
  const Result<arm::HsesRequest> request = arm::read_hses_request(datagram);
  const bool heard = request && cabinet_.powered();
  if (!heard) co_return std::string();
  const Outcome outcome = co_await carry_out(*request);
  // It may have lost its power meanwhile.
  if (!cabinet_.powered()) co_return std::string();
  arm::HsesReply reply{.id = request->id};
  reply.service = request->service | arm::hses::answered;
  reply.status = outcome.refusal == 0 ? 0 : abnormal;
  reply.added_status = outcome.refusal;
  reply.data = outcome.data;
  co_return arm::write_hses(reply);
}

Task<HsesEmulator::Outcome> HsesEmulator::at_once(Outcome outcome) { co_return outcome; }

Task<HsesEmulator::Outcome> HsesEmulator::carry_out(arm::HsesRequest request) {
  switch (request.command) {
    case arm::hses::status:
      return status();
    case arm::hses::position:
      return position(request.instance);
    case arm::hses::double_integer:
      return variable(std::move(request));
    case arm::hses::move_pulses:
      return move_pulses(std::move(request));
    case arm::hses::move_cartesian:
      return move_cartesian(std::move(request));
    default:
      return at_once(turn(request));
  }
}

Task<HsesEmulator::Outcome> HsesEmulator::status() {
  const MotomanController::Words words = co_await controller_.status();
  Outcome outcome;
  outcome.data = line::OctetWriter(line::ByteOrder::little).u32(words.modes).u32(words.states).octets();
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::position(std::uint16_t instance) {
  Outcome outcome;
  if (instance == arm::hses::robot_pulses) {
    const arm::MotomanPulses pulses = co_await controller_.pulses();
    outcome.data = position_data(0, pulses);
  } else if (instance == arm::hses::robot_base) {
    const arm::MotomanPose pose = co_await controller_.pose();
    arm::MotomanPulses axes{};
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i] = rounded(pose.place_mm[i] * arm::um_per_mm);
      axes[i + 3] = rounded(pose.angles_deg[i] * units_per_deg);
    }
    outcome.data = position_data(arm::hses::base_frame, axes);
  } else {
    outcome.refusal = arm::hses::wrong_instance;
  }
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::variable(arm::HsesRequest request) {
  Outcome outcome;
  if (request.instance >= MotomanController::variables) {
    outcome.refusal = arm::hses::wrong_instance;
    co_return outcome;
  }
  if (request.service == arm::hses::get_one) {
    const std::int32_t value = co_await controller_.variable(request.instance);
    outcome.data = line::OctetWriter(line::ByteOrder::little).i32(value).octets();
    co_return outcome;
  }
  line::OctetReader read(request.data, line::ByteOrder::little);
  const std::int32_t value = read.i32();
  const bool sound = request.service == arm::hses::set_one && read.whole();
  if (!sound) {
    outcome.refusal = arm::hses::wrong_size;
    co_return outcome;
  }
  const Refusal refusal = co_await controller_.set_variable(request.instance, value);
  outcome.refusal = code_of(refusal);
  co_return outcome;
}

// Switches, resets, and what of an alarm is known.
HsesEmulator::Outcome HsesEmulator::turn(const arm::HsesRequest& request) {
  if (request.command == arm::hses::alarm) {
    const bool code = request.instance == 1 && request.attribute == 1 && request.service == arm::hses::get_one;
    if (!code) return {.refusal = arm::hses::wrong_attribute};
    const auto alarm = static_cast<std::uint32_t>(cabinet_.alarm());
    return {.data = line::OctetWriter(line::ByteOrder::little).u32(alarm).octets()};
  }
  line::OctetReader read(request.data, line::ByteOrder::little);
  const std::uint32_t wanted = read.u32();
  if (request.command != arm::hses::reset && request.command != arm::hses::power)
    return {.refusal = arm::hses::undefined_command};
  if (request.attribute != 1 || request.service != arm::hses::set_one) return {.refusal = arm::hses::wrong_attribute};
  if (!read.whole()) return {.refusal = arm::hses::wrong_size};
  if (request.command == arm::hses::reset) {
    if (request.instance == arm::hses::cancel_error) return {};
    if (request.instance != arm::hses::reset_alarm) return {.refusal = arm::hses::wrong_instance};
    return {.refusal = code_of(cabinet_.reset())};
  }
  if (wanted != arm::hses::on && wanted != arm::hses::off) return {.refusal = arm::hses::out_of_range};
  if (request.instance == arm::hses::hold) return {.refusal = code_of(cabinet_.hold(wanted == arm::hses::on))};
  if (request.instance != arm::hses::servo) return {.refusal = arm::hses::wrong_instance};
  const Refusal refusal = cabinet_.servo(wanted == arm::hses::on);
  return {.refusal = refusal == Refusal::emergency ? arm::motoman::servo_refused : code_of(refusal)};
}

Task<HsesEmulator::Outcome> HsesEmulator::move_pulses(arm::HsesRequest request) {
  Outcome outcome;
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
  constexpr std::uint32_t whole = 10'000;
  if (!read.whole()) {
    outcome.refusal = arm::hses::wrong_size;
  } else if (robot != 1 || request.instance != arm::hses::joint_move) {
    outcome.refusal = arm::hses::wrong_instance;
  } else if (speed_class != arm::hses::percent || speed < 1 || speed > whole) {
    outcome.refusal = arm::hses::wrong_speed;
  } else {
    const double part = static_cast<double>(speed) / whole;
    const Refusal refusal = co_await controller_.move_joints(target, part);
    outcome.refusal = code_of(refusal);
  }
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::move_cartesian(arm::HsesRequest request) {
  Outcome outcome;
  line::OctetReader read(request.data, line::ByteOrder::little);
  const std::uint32_t robot = read.u32();
  read.u32();
  const std::uint32_t speed_class = read.u32();
  const std::uint32_t speed = read.u32();
  const std::uint32_t frame = read.u32();
  arm::MotomanPose target;
  for (double& mm : target.place_mm) mm = read.i32() / arm::um_per_mm;
  for (double& deg : target.angles_deg) deg = read.i32() / units_per_deg;
  // The seventh axis, form, tool and user frame, and what is reserved.
  read.text(6 * 4 + 36);
  if (!read.whole()) {
    outcome.refusal = arm::hses::wrong_size;
  } else if (robot != 1 || request.instance != arm::hses::linear_move) {
    outcome.refusal = arm::hses::wrong_instance;
  } else if (frame != arm::hses::base_frame) {
    outcome.refusal = arm::hses::wrong_frame;
  } else if (speed_class != arm::hses::millimetres || speed < 1) {
    outcome.refusal = arm::hses::wrong_speed;
  }
  if (outcome.refusal != 0) co_return outcome;
  const Refusal refusal = co_await controller_.move_straight(target, speed / 10.0);
  outcome.refusal = code_of(refusal);
  co_return outcome;
}

Task<void> serve(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port) {
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

}  // namespace pizarra::simulation
