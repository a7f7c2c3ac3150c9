#include "drivers/simulation/controllers/arms/hses_emulator.hpp"

#include <cmath>

#include "drivers/arm/motoman/motoman_codes.hpp"
#include "drivers/line/octets.hpp"

namespace pizarra {

namespace {

constexpr std::uint8_t abnormal = 0x1f;
constexpr double um_per_mm = 1000;
constexpr double units_per_deg = 10'000;
constexpr std::size_t axes_in_a_move = 7;

std::uint16_t code_of(Refusal refusal) {
  return refusal == Refusal::out_of_range ? hses::out_of_range : motoman_code(refusal);
}

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::llround(value)); }

std::string position_data(std::uint32_t kind, const MotomanPulses& axes) {
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
  const MotomanController::Words words = co_await controller_.status();
  Outcome outcome;
  outcome.data = OctetWriter(ByteOrder::little).u32(words.modes).u32(words.states).octets();
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::position(std::uint16_t instance) {
  Outcome outcome;
  if (instance == hses::robot_pulses) {
    const MotomanPulses pulses = co_await controller_.pulses();
    outcome.data = position_data(0, pulses);
  } else if (instance == hses::robot_base) {
    const MotomanPose pose = co_await controller_.pose();
    MotomanPulses axes{};
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i] = rounded(pose.place_mm[i] * um_per_mm);
      axes[i + 3] = rounded(pose.angles_deg[i] * units_per_deg);
    }
    outcome.data = position_data(hses::base_frame, axes);
  } else {
    outcome.refusal = hses::wrong_instance;
  }
  co_return outcome;
}

Task<HsesEmulator::Outcome> HsesEmulator::variable(HsesRequest request) {
  Outcome outcome;
  if (request.instance >= MotomanController::variables) {
    outcome.refusal = hses::wrong_instance;
    co_return outcome;
  }
  if (request.service == hses::get_one) {
    const std::int32_t value = co_await controller_.variable(request.instance);
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
  const Refusal refusal = co_await controller_.set_variable(request.instance, value);
  outcome.refusal = code_of(refusal);
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
  return {.refusal = refusal == Refusal::emergency ? motoman::servo_refused : code_of(refusal)};
}

Task<HsesEmulator::Outcome> HsesEmulator::move_pulses(HsesRequest request) {
  Outcome outcome;
  OctetReader read(request.data, ByteOrder::little);
  const std::uint32_t robot = read.u32();
  read.u32();
  const std::uint32_t speed_class = read.u32();
  const std::uint32_t speed = read.u32();
  MotomanPulses target{};
  for (std::size_t axis = 0; axis < axes_in_a_move; ++axis) target[axis] = read.i32();
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
    const double part = static_cast<double>(speed) / whole;
    const Refusal refusal = co_await controller_.move_joints(target, part);
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
  MotomanPose target;
  for (double& mm : target.place_mm) mm = read.i32() / um_per_mm;
  for (double& deg : target.angles_deg) deg = read.i32() / units_per_deg;
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
  const Refusal refusal = co_await controller_.move_straight(target, speed / 10.0);
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
