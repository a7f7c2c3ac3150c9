#include "drivers/simulation/controllers/gripper/gripper_emulator.hpp"

#include <cmath>
#include <fmt/format.h>

#include "lisp/plain_text.hpp"

namespace pizarra::simulation {

namespace {

constexpr double at_target_mm = 1;
// Where Robotiq's grippers repeat what they were told.
constexpr forms::RegisterField activate_echo{2000, 8, 1};
constexpr forms::RegisterField go_echo{2000, 11, 1};
constexpr forms::RegisterField target_echo{2001, 0, 8};

std::optional<int> number_after(std::string_view words, std::string_view what) {
  if (!words.starts_with(what)) return std::nullopt;
  return number_from(words.substr(what.size()), 0, 255);
}

}  // namespace

GripperEmulator::GripperEmulator(Executor& executor, arm::ArmDriver& body, const forms::GripperSetup& setup)
    : executor_(executor),
      body_(body),
      setup_(setup),
      orders_(gripper::orders_of(setup)),
      states_(gripper::states_of(setup)),
      echoes_(gripper::states_of(setup) == gripper::states_of({})),
      living_(executor.spawn(live())) {}

double GripperEmulator::wanted_mm() const {
  const double range = setup_.open_count - setup_.closed_count;
  return std::lerp(setup_.closed_mm, setup_.open_mm, (orders_.get(setup_.target) - setup_.closed_count) / range);
}

bool GripperEmulator::active() const { return active_since_ && executor_.now() - *active_since_ >= activation_time; }

void GripperEmulator::told(gripper::RegisterImage orders) {
  const bool goes_elsewhere =
      orders.get(setup_.target) != orders_.get(setup_.target) || orders.get(setup_.go) != orders_.get(setup_.go);
  orders_ = std::move(orders);
  const bool go = orders_.get(setup_.go) != 0;
  if (orders_.get(setup_.activate) == 0) {
    active_since_.reset();
    fault_ = 0;
    states_.put(setup_.object, gripper::gripper::on_its_way);
  } else if (!active_since_ && fault_ == 0) {
    active_since_ = executor_.now();
  }
  const bool stops = goes_ && (!go || !active_since_);
  if (stops) {
    goes_ = false;
    sending_ = executor_.spawn(send_to(opening_mm_));
  } else if (goes_elsewhere && go && active()) {
    go_there();
  }
  const bool can_go = go && active_since_;
  delayed_ = can_go && (delayed_ || !active());
  tell();
}

void GripperEmulator::go_there() {
  delayed_ = false;
  ++sent_;
  goes_ = true;
  states_.put(setup_.object, gripper::gripper::on_its_way);
  sending_ = executor_.spawn(send_to(wanted_mm()));
}

// Its answers about itself besides the place of its fingers.
void GripperEmulator::tell() {
  states_.put(setup_.fault, static_cast<std::uint16_t>(fault_));
  states_.put(setup_.active, active() ? gripper::gripper::ready : active_since_ ? 1 : 0);
  if (!echoes_) return;
  states_.put(activate_echo, orders_.get(setup_.activate));
  states_.put(go_echo, orders_.get(setup_.go));
  states_.put(target_echo, orders_.get(setup_.target));
}

Task<void> GripperEmulator::send_to(double opening_mm) {
  Result<void> sent = co_await body_.start_gripper(opening_mm);
  if (!sent && sent.error().symbol == "not-in-control") {
    const Result<void> control = co_await body_.take_control();
    if (control) sent = co_await body_.start_gripper(opening_mm);
  }
  constexpr int internal_fault = 15;
  if (!sent) fault_ = internal_fault;
}

Task<void> GripperEmulator::live() {
  while (true) {
    const Result<arm::ArmReading> reading = co_await body_.read();
    if (delayed_ && active()) go_there();
    if (reading && sending_.done()) look(*reading);
    co_await sleep(executor_, look_every);
  }
}

void GripperEmulator::look(const arm::ArmReading& reading) {
  opening_mm_ = reading.opening_mm;
  const double part = (opening_mm_ - setup_.closed_mm) / (setup_.open_mm - setup_.closed_mm);
  const double count = std::lerp(setup_.closed_count, setup_.open_count, std::clamp(part, 0.0, 1.0));
  states_.put(setup_.opening, static_cast<std::uint16_t>(std::lround(count)));
  tell();
  if (reading.gripper_moving) return;
  const double short_of = opening_mm_ - wanted_mm();
  const std::uint16_t met = short_of > 0 ? gripper::gripper::met_closing : gripper::gripper::met_opening;
  if (goes_) states_.put(setup_.object, std::abs(short_of) <= at_target_mm ? gripper::gripper::arrived : met);
  goes_ = false;
}

Result<void> GripperEmulator::obey(std::string_view words) {
  const std::optional<int> fault = number_after(words, "fault ");
  const std::optional<int> exception = number_after(words, "refuse ");
  if (fault) {
    fault_ = *fault;
    if (fault_ != 0) active_since_.reset();
  } else if (exception) {
    exception_ = *exception;
  } else if (words == "power on" || words == "power off") {
    powered_ = words == "power on";
    active_since_.reset();
  } else {
    return fail("unknown-command", fmt::format("nobody here understands '{}': power on, power off, fault CODE, "
                                               "refuse CODE, status",
                                               words));
  }
  return {};
}

std::string GripperEmulator::status() const {
  std::string line = fmt::format("power {}, {}", powered_ ? "on" : "off", active_since_ ? "active" : "not active");
  if (fault_ != 0) line += fmt::format(", fault {}", fault_);
  if (exception_ != 0) line += fmt::format(", refuses with {}", exception_);
  const std::uint16_t object = states_.get(setup_.object);
  const bool holds = object == gripper::gripper::met_closing || object == gripper::gripper::met_opening;
  return fmt::format("{}, {} at {:.1f} mm{}", line, goes_ ? "moving" : "still", opening_mm_,
                     holds ? ", something between its fingers" : "");
}

std::string GripperEmulator::status_in_json() const {
  const std::uint16_t object = states_.get(setup_.object);
  return fmt::format(
      "{{\"power\":{},\"active\":{},\"fault\":{},\"refuses\":{},\"state\":\"{}\",\"opening\":{:.2f},\"gripped\":{}}}",
      powered_, active_since_.has_value(), fault_, exception_, goes_ ? "moving" : "still", opening_mm_,
      object == gripper::gripper::met_closing || object == gripper::gripper::met_opening);
}

}  // namespace pizarra::simulation
