#include "drivers/arm/universal/universal_arm.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/angles.hpp"
#include "drivers/arm/move_check.hpp"
#include "drivers/wire/printable.hpp"

namespace pizarra {

namespace {

constexpr double wrist_2_deg = -90;
constexpr double wrist_2_slack_deg = 0.5;
constexpr std::size_t wrist_2 = 4;  // between the fourth axis of five and the last
constexpr Duration look_again = 8ms;

}  // namespace

UniversalArm::UniversalArm(Executor& executor, UniversalWires wires, ArmModel model)
    : executor_(executor),
      wires_(wires),
      model_(std::move(model)),
      rtde_(wires.rtde, rtde::frame),
      dashboard_(wires.dashboard, frame_of_line),
      turns_(executor) {}

bool UniversalArm::known() const { return told_at_ && executor_.now() - *told_at_ <= fresh; }

Joints UniversalArm::joints() const {
  const auto& q = state_.joints_rad;
  return {degrees(q[0]), degrees(q[1]), degrees(q[2]), degrees(q[3]), degrees(q[5])};
}

Task<Result<std::string>> UniversalArm::ask_rtde(char type, std::string payload) {
  const Result<void> sent = wires_.rtde.write(rtde::write(type, payload));
  if (!sent) co_return fail(sent);
  const Time deadline = executor_.now() + answer_time;
  while (true) {
    Result<std::string> answer = co_await rtde_.next(deadline);
    if (!answer) co_return answer;
    if (answer->front() == type) co_return answer->substr(1);
  }
}

Task<Result<std::string>> UniversalArm::ask_dashboard(std::string question) {
  const Turns::Turn turn = co_await turns_.take();
  const Result<void> sent = wires_.dashboard.write(question + "\n");
  if (!sent) co_return fail("disconnected", sent.error().sentence);
  const Time deadline = executor_.now() + answer_time;
  Result<std::string> answer = co_await dashboard_.next(deadline);
  if (!answer) co_return fail("disconnected", "the dashboard server did not answer: " + answer.error().sentence);
  co_return answer;
}

Task<Result<std::string>> UniversalArm::identify() {
  listening_ = Job();
  told_at_.reset();
  const Time deadline = executor_.now() + answer_time;
  for (ByteWire* wire : {&wires_.rtde, &wires_.script, &wires_.dashboard}) {
    const Result<void> open = co_await wire->open(deadline);
    if (!open) co_return fail(open);
  }
  rtde_.clear();
  dashboard_.clear();
  const Result<std::string> greeting = co_await dashboard_.next(deadline);
  if (!greeting) co_return fail("disconnected", "the dashboard server does not greet");
  const Result<std::string> kind = co_await ask_dashboard("get robot model");
  if (!kind) co_return fail(kind);
  std::string version = OctetWriter(ByteOrder::big).u16(2).octets();
  const Result<std::string> accepted = co_await ask_rtde(rtde::version, std::move(version));
  if (!accepted) co_return fail(accepted);
  std::string wanted = OctetWriter(ByteOrder::big).f64(told_per_s).text(rtde::state_names).octets();
  const Result<std::string> types = co_await ask_rtde(rtde::outputs, std::move(wanted));
  if (!types) co_return fail(types);
  if (types->substr(std::min<std::size_t>(1, types->size())) != rtde::state_types) {
    co_return fail("bad-reply", fmt::format("the arm cannot tell its state: {}", printable(*types)));
  }
  const Result<std::string> input = co_await ask_rtde(rtde::inputs, std::string(rtde::opening_name));
  if (!input) co_return fail(input);
  input_recipe_ = static_cast<std::uint8_t>(input->empty() ? 0 : input->front());
  const Result<std::string> started = co_await ask_rtde(rtde::start, "");
  if (!started) co_return fail(started);
  listening_ = executor_.spawn(listen());
  std::function<bool()> heard = [this] { return known(); };
  const bool told = co_await comes_true(std::move(heard), answer_time);
  if (!told) co_return fail("disconnected", "the arm does not tell its state");
  programs_ = std::max(programs_, state_.marker / 2);
  std::string type;
  for (const char c : *kind) type += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const bool stands = std::abs(degrees(state_.joints_rad[wrist_2]) - wrist_2_deg) <= wrist_2_slack_deg;
  if (!stands) co_return fail("unknown-arm", "wrist 2 does not stand at -90 degrees", to_datum(wrist_2 + 1));
  // An e-Series controller says UR5 of a UR5e.
  co_return model_.type.starts_with(type) ? model_.type : printable(type);
}

Task<void> UniversalArm::listen() {
  while (true) {
    const Time deadline = executor_.now() + power_time;
    const Result<std::string> message = co_await rtde_.next(deadline);
    if (!message && message.error().symbol == "timeout") continue;
    Result<rtde::State> state;
    if (message && message->front() != rtde::data) continue;
    if (message) state = rtde::read_state(std::string_view(*message).substr(1));
    if (!message || !state) {
      why_unknown_ = message ? state.error().sentence : message.error().sentence;
      told_at_.reset();
      co_return;
    }
    state_ = *state;
    told_at_ = executor_.now();
  }
}

Task<bool> UniversalArm::comes_true(std::function<bool()> what, Duration patience) {
  const Time deadline = executor_.now() + patience;
  while (!what()) {
    if (executor_.now() >= deadline) co_return false;
    co_await sleep(executor_, look_again);
  }
  co_return true;
}

// Why an arm that was asked to move does not.
Failure UniversalArm::trouble() const {
  constexpr std::string_view safety[] = {"",          "",          "",          "a protective stop", "recovery",
                                         "safeguard", "emergency", "emergency", "a violation",       "a fault"};
  const auto mode = static_cast<std::size_t>(state_.safety_mode);
  if (mode >= 3 && mode < std::size(safety)) {
    return {"not-in-control", fmt::format("the arm is in {} stop", safety[mode]), to_datum(state_.safety_mode), {}};
  }
  if (state_.robot_mode != rtde::running_mode) {
    return {"not-in-control", "the arm is not switched on", to_datum(state_.robot_mode), {}};
  }
  return {"not-in-control", "the arm takes no program, as one in local control does", {}, {}};
}

Task<Result<void>> UniversalArm::take_control() {
  if (!known()) co_return fail("disconnected", why_unknown_);
  const Result<std::string> remote = co_await ask_dashboard("is in remote control");
  if (!remote) co_return fail(remote);
  if (*remote != "true") co_return fail("not-in-control", "the pendant has control: the arm is in local control");
  for (const char* order : {"unlock protective stop", "power on", "brake release"}) {
    const Result<std::string> done = co_await ask_dashboard(order);
    if (!done) co_return fail(done);
  }
  std::function<bool()> ready = [this] { return state_.robot_mode == rtde::running_mode && state_.safety_mode <= 2; };
  // An emergency stop is released by hand alone.
  const Duration patience = state_.safety_mode > 3 ? answer_time : power_time;
  const bool on = co_await comes_true(std::move(ready), patience);
  if (!on) co_return fail(trouble());
  co_return Result<void>();
}

std::string UniversalArm::program(const std::vector<Leg>& legs, double speed, const Joints& from) const {
  std::string text = fmt::format("def pizarra():\n  write_output_integer_register(24, {})\n", 2 * programs_);
  Joints at = from;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    const Joints& to = legs[i].to;
    const double seconds = std::max(legs[i].seconds / speed, 1e-3);
    double way = 0;  // of the leading axis, or of the tool
    for (std::size_t axis = 0; axis < to.size(); ++axis) way = std::max(way, radians(std::abs(to[axis] - at[axis])));
    if (legs[i].straight) way = (forward(model_, to).translation() - forward(model_, at).translation()).norm() / 1000;
    const double v = way / seconds;
    text += fmt::format("  {}([{:.6f}, {:.6f}, {:.6f}, {:.6f}, {:.6f}, {:.6f}], a={:.4f}, v={:.4f}, r={})\n",
                        legs[i].straight ? "movel" : "movej", radians(to[0]), radians(to[1]), radians(to[2]),
                        radians(to[3]), radians(wrist_2_deg), radians(to[4]), std::max(4 * v, 0.01), std::max(v, 0.001),
                        i + 1 < legs.size() ? "0.001" : "0");
    at = to;
  }
  return text + fmt::format("  write_output_integer_register(24, {})\nend\n", 2 * programs_ + 1);
}

Task<Result<void>> UniversalArm::start_move(std::vector<Joints> waypoints, double speed) {
  const Result<void> sound = check_move(model_, waypoints, speed);
  if (!sound) co_return sound;
  if (!known()) co_return fail("disconnected", why_unknown_);
  if (moving_) co_return fail("busy", "the arm is moving already");
  if (state_.robot_mode != rtde::running_mode || state_.safety_mode > 2) co_return fail(trouble());
  ++programs_;
  stopping_ = false;
  const Joints from = joints();
  const std::vector<Leg> legs = legs_of(model_, from, waypoints);
  const Result<void> sent = wires_.script.write(program(legs, speed, from));
  if (!sent) co_return fail(sent);
  const std::int32_t begun = 2 * programs_;
  std::function<bool()> has_begun = [this, begun] { return state_.marker >= begun; };
  const bool begins = co_await comes_true(std::move(has_begun), answer_time);
  if (!begins) co_return fail(trouble());
  moving_ = true;
  co_return Result<void>();
}

Task<Result<void>> UniversalArm::stop() {
  stopping_ = true;
  co_return wires_.script.write("def pizarra_stops():\n  stopj(8.0)\nend\n");
}

Task<Result<void>> UniversalArm::start_gripper(double opening_mm) {
  if (!std::isfinite(opening_mm)) co_return fail("not-finite", "the opening is not a number");
  OctetWriter input(ByteOrder::big);
  input.u8(input_recipe_).f64(opening_mm);
  gripping_until_ = executor_.now() + fresh;
  co_return wires_.rtde.write(rtde::write(rtde::data, input.octets()));
}

Task<Result<ArmReading>> UniversalArm::read() {
  if (!known()) co_return fail("disconnected", why_unknown_);
  const bool ended = state_.marker == 2 * programs_ + 1;
  const bool stands = state_.runtime != rtde::playing;
  ArmReading reading{.joints = joints(),
                     .moving = moving_,
                     .stopped = false,
                     .opening_mm = state_.opening_mm,
                     .gripper_moving = state_.fingers != 0 || executor_.now() < gripping_until_};
  if (moving_ && (ended || stands)) moving_ = false;
  reading.moving = !stands;
  reading.stopped = !ended && programs_ > 0;
  const bool unasked = reading.stopped && !stopping_ && !reading.moving;
  if (unasked) {
    reading.why_stopped = trouble();
    reading.why_stopped->symbol = "stopped";
  }
  co_return reading;
}

}  // namespace pizarra
