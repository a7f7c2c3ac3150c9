#include "drivers/simulation/controllers/arms/hses_emulator.hpp"

#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/line/octets.hpp"
#include "drivers/simulation/controllers/arms/hses_codes.hpp"
#include "drivers/simulation/controllers/arms/hses_moves.hpp"
#include "drivers/simulation/controllers/serve.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::uint8_t abnormal = 0x1f;

// Why a request is none that sets this many octets; 0 where it is.
std::uint16_t wrong_setting(const arm::HsesRequest& request, std::size_t octets) {
  if (request.service != arm::hses::set_one) return arm::hses::undefined_command;
  if (request.attribute != 1) return arm::hses::wrong_attribute;
  return request.data.size() == octets ? std::uint16_t{0} : arm::hses::wrong_size;
}

Task<HsesOutcome> at_once(HsesOutcome outcome) { co_return outcome; }

}  // namespace

Task<std::string> HsesEmulator::answer(std::string datagram) {
  const Result<arm::HsesRequest> request = arm::read_hses_request(datagram);
  const bool heard = request && cabinet_.powered();
  const bool no_servos = !cabinet_.servo() && !cabinet_.servo_comes_on();
  const bool job_ends = !cabinet_.powered() || no_servos || cabinet_.command_hold() || cabinet_.pendant_hold();
  if (job_ends) jobs_.end();
  if (!heard) co_return std::string();
  const HsesOutcome outcome = co_await carry_out(*request);
  // It may have lost its power meanwhile.
  if (!cabinet_.powered()) co_return std::string();
  arm::HsesReply reply{.id = request->id};
  reply.service = request->service | arm::hses::answered;
  reply.status = outcome.refusal == 0 ? 0 : abnormal;
  reply.added_status = outcome.refusal;
  reply.data = outcome.data;
  co_return arm::write_hses(reply);
}

Task<HsesOutcome> HsesEmulator::carry_out(arm::HsesRequest request) {
  if (HsesVariables::has(request.command)) return variables_.carry_out(std::move(request));
  switch (request.command) {
    case arm::hses::status:
      return reports_.status(std::move(request));
    case arm::hses::position:
      return reports_.position(std::move(request));
    case arm::hses::alarm:
    case hses::alarm_history:
      return at_once(reports_.alarm(request));
    case arm::hses::move_pulses:
      return hses_move_pulses(controller_, std::move(request));
    case arm::hses::move_cartesian:
      return hses_move_cartesian(controller_, std::move(request));
    case hses::executing_job:
    case hses::axis_names:
    case hses::position_error:
    case hses::torque:
    case hses::system_information:
      return at_once(reports_.report(request));
    case hses::management_time:
      return at_once(reports_.management_time(request));
    case hses::select_job:
      return at_once(jobs_.select(request));
    default:
      return at_once(turn(request));
  }
}

// Switches, resets, and what is told to the pendant.
HsesOutcome HsesEmulator::turn(const arm::HsesRequest& request) {
  const std::uint16_t instance = request.instance;
  const bool known = request.command == arm::hses::reset || request.command == arm::hses::power ||
                     request.command == hses::cycle || request.command == hses::pendant_text ||
                     request.command == hses::start_job;
  if (!known) return {.refusal = arm::hses::undefined_command};
  constexpr std::size_t text_size = 32;
  const std::uint16_t wrong = wrong_setting(request, request.command == hses::pendant_text ? text_size : 4);
  if (wrong != 0) return {.refusal = wrong};
  const std::uint32_t wanted = line::OctetReader(request.data, line::ByteOrder::little).u32();
  if (request.command == arm::hses::reset) {
    if (instance == arm::hses::cancel_error) return {};
    if (instance != arm::hses::reset_alarm) return {.refusal = arm::hses::wrong_instance};
    return {.refusal = hses_code(cabinet_.reset())};
  }
  if (request.command == arm::hses::power) return {.refusal = turn_power(instance, wanted)};
  if (request.command == hses::cycle) {
    constexpr std::uint16_t cycle_instance = 2;
    if (instance != cycle_instance) return {.refusal = arm::hses::wrong_instance};
    return {.refusal = controller_.set_cycle(wanted) ? std::uint16_t{0} : arm::hses::out_of_range};
  }
  if (instance != 1) return {.refusal = arm::hses::wrong_instance};
  return {.refusal = request.command == hses::start_job ? jobs_.start() : std::uint16_t{0}};
}

// The interlock keeps the pendant's keys from doing anything: nobody presses them here.
std::uint16_t HsesEmulator::turn_power(std::uint16_t instance, std::uint32_t wanted) {
  const bool on = wanted == arm::hses::on;
  if (!on && wanted != arm::hses::off) return arm::hses::out_of_range;
  if (instance == hses::interlock) return 0;
  if (instance == arm::hses::hold) return hses_code(cabinet_.hold(on));
  if (instance != arm::hses::servo) return arm::hses::wrong_instance;
  const Refusal refusal = cabinet_.servo(on);
  return refusal == Refusal::emergency ? arm::motoman::servo_refused : hses_code(refusal);
}

std::string HsesEmulator::answer_about_files(std::string_view datagram) {
  return cabinet_.powered() ? files_.answer(datagram) : std::string();
}

namespace {

// Each datagram's answer, for as long as this lives.
template <class Answer>
Task<void> serve_datagrams(Executor& executor, line::DatagramWire& port, Answer answer) {
  while (true) {
    const Time heard_by = executor.now() + opening_patience;
    Result<std::string> datagram = co_await port.receive(heard_by);
    if (!datagram) {
      if (datagram.error().symbol != "timeout") co_await sleep(executor, opening_pause);
      continue;
    }
    const std::string reply = co_await answer(std::move(*datagram));
    // What nobody takes is lost, as on any line.
    if (!reply.empty()) static_cast<void>(port.send(reply));
  }
}

Task<std::string> answer_file(HsesEmulator& emulator, std::string datagram) {
  co_return emulator.answer_about_files(datagram);
}

}  // namespace

Task<void> serve(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port) {
  return serve_datagrams(executor, port,
                         [&emulator](std::string datagram) { return emulator.answer(std::move(datagram)); });
}

Task<void> serve_files(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port) {
  return serve_datagrams(executor, port,
                         [&emulator](std::string datagram) { return answer_file(emulator, std::move(datagram)); });
}

}  // namespace pizarra::simulation
