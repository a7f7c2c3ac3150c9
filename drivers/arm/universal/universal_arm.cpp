#include "drivers/arm/universal/universal_arm.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fmt/format.h>

#include "drivers/arm/move_check.hpp"
#include "drivers/arm/universal/move_script.hpp"
#include "drivers/line/printable.hpp"
#include "lisp/numbers.hpp"
#include "lisp/plain_text.hpp"

namespace pizarra::arm {

namespace {

constexpr double wrist_2_slack_deg = 0.5;
constexpr double standing_deg = 0.01;  // from one state to the next
constexpr std::size_t wrist_2 = 4;     // between the fourth axis of five and the last
constexpr int safety_violation = 8;    // and fault above it
constexpr int e_series = 5;            // its major version; before it 3

// As in the arm's file, `ur5e` of UR5 and URSoftware 5.11.0; nothing of what is none.
std::optional<std::string> type_of_model(std::string_view model, std::string_view version) {
  std::string type = lowered(model);
  version.remove_prefix(std::min(version.find_first_of("0123456789"), version.size()));
  int major = 0;
  const std::errc wrong = std::from_chars(version.data(), version.data() + version.size(), major).ec;
  if (wrong != std::errc() || !type.starts_with("ur") || line::printable(type) != type) return {};
  constexpr std::string_view without_e[] = {"ur3", "ur5", "ur10", "ur16"};  // is what an e-Series says of each
  const bool shortened = std::ranges::find(without_e, type) != std::end(without_e);
  if (shortened && major >= e_series) type += 'e';
  return type;
}

}  // namespace

UniversalArm::UniversalArm(Executor& executor, UniversalWires wires, ArmModel model)
    : executor_(executor),
      model_(std::move(model)),
      script_(wires.script),
      rtde_(executor, wires.rtde, rtde::frame, "the arm"),
      dashboard_(executor, wires.dashboard, line::frame_of_line, "the dashboard server"),
      told_(rtde_, fresh) {}

bool UniversalArm::able() const { return state_.robot_mode == rtde::running_mode && state_.safety_mode <= 2; }

Joints UniversalArm::joints() const {
  const auto& q = state_.joints_rad;
  return {degrees(q[0]), degrees(q[1]), degrees(q[2]), degrees(q[3]), degrees(q[5])};
}

Task<Result<std::string>> UniversalArm::ask_rtde(char type, std::string payload) {
  line::Dialogue::Fits same_type = [type](const std::string& answer) { return answer.front() == type; };
  std::string question = rtde::write(type, payload);
  Result<std::string> answer = co_await rtde_.ask(std::move(question), std::move(same_type));
  if (answer) answer->erase(0, 1);
  co_return answer;
}

// Has the arm tell its state.
Task<Result<void>> UniversalArm::subscribe() {
  std::string version = line::OctetWriter(line::ByteOrder::big).u16(2).octets();
  const Result<std::string> accepted = co_await ask_rtde(rtde::version, std::move(version));
  if (!accepted) co_return fail(accepted);
  std::string wanted = line::OctetWriter(line::ByteOrder::big).f64(told_per_s).text(rtde::state_names).octets();
  const Result<std::string> types = co_await ask_rtde(rtde::outputs, std::move(wanted));
  if (!types) co_return fail(types);
  if (types->substr(std::min<std::size_t>(1, types->size())) != rtde::state_types) {
    co_return fail("bad-reply", fmt::format("the arm cannot tell its state: {}", line::printable(*types)));
  }
  const Result<std::string> input = co_await ask_rtde(rtde::inputs, std::string(rtde::opening_name));
  if (!input) co_return fail(input);
  input_recipe_ = static_cast<std::uint8_t>(input->empty() ? 0 : input->front());
  const Result<std::string> started = co_await ask_rtde(rtde::start, "");
  if (!started) co_return fail(started);
  line::ToldState::Hear hears = [this](const std::string& message) { return hear(message); };
  Result<void> known = co_await told_.listen(std::move(hears), answer_time);
  co_return known;
}

Task<Result<std::string>> UniversalArm::ask_type() {
  Result<std::string> model = co_await dashboard_.ask("get robot model\n");
  if (!model) co_return model;
  const Result<std::string> version = co_await dashboard_.ask("PolyscopeVersion\n");
  if (!version) co_return version;
  const std::optional<std::string> type = type_of_model(*model, *version);
  if (type) co_return *type;
  co_return fail("bad-reply", fmt::format("the dashboard server does not say which arm it is of: {}, {}",
                                          line::printable(*model), line::printable(*version)));
}

// An arm that does not know the question has no local control.
Task<Result<void>> UniversalArm::ask_mode() {
  const Result<std::string> remote = co_await dashboard_.ask("is in remote control\n");
  if (!remote) co_return fail(remote);
  local_ = *remote == "false";
  co_return Result<void>();
}

// Where the controller does not answer, its last word holds.
Task<void> UniversalArm::ask_mode_again() { [[maybe_unused]] const Result<void> asked = co_await ask_mode(); }

Task<Result<std::string>> UniversalArm::identify() {
  told_.forget();
  asking_mode_ = Job();
  const Time deadline = executor_.now() + answer_time;
  // Each of them, whatever becomes of the others: a stop needs only one of the last two.
  const Result<void> script = co_await open_script(deadline);
  const Result<void> dashboard = co_await dashboard_.open(deadline);
  const Result<void> rtde = co_await rtde_.open(deadline);
  for (const Result<void>& open : {rtde, script, dashboard}) {
    if (!open) co_return fail(open);
  }
  const Result<std::string> greeting = co_await dashboard_.next(deadline);
  if (!greeting) co_return fail("disconnected", "the dashboard server does not greet");
  Result<std::string> type = co_await ask_type();
  if (!type) co_return type;
  const Result<void> mode = co_await ask_mode();
  if (!mode) co_return fail(mode);
  const Result<void> told = co_await subscribe();
  if (!told) co_return fail(told);
  programs_ = std::max(programs_, state_.marker / 2);
  const bool stands = std::abs(degrees(state_.joints_rad[wrist_2]) - wrist_2_deg) <= wrist_2_slack_deg;
  if (!stands)
    co_return fail("unknown-arm", "wrist 2 does not stand at -90 degrees: turn it there by the pendant",
                   to_datum(wrist_2 + 1));
  co_return type;
}

Task<Result<void>> UniversalArm::open_script(Time deadline) {
  passing_over_ = Job();
  const Result<void> open = co_await script_.open(deadline);
  if (!open) co_return open;
  passing_over_ = executor_.spawn(pass_over_chatter());
  co_return Result<void>();
}

// The controller tells of itself where it takes programs, ten times a second and more, whether anybody reads it or not.
Task<void> UniversalArm::pass_over_chatter() {
  while (true) {
    const Time deadline = executor_.now() + look_again;
    const Result<std::string> chatter = co_await script_.read(deadline);
    if (!chatter && chatter.error().symbol != "timeout") co_return;
  }
}

Result<bool> UniversalArm::hear(const std::string& message) {
  if (message.front() != rtde::data) return false;
  const Result<rtde::State> state = rtde::read_state(std::string_view(message).substr(1));
  if (!state) return fail(state);
  for (std::size_t axis = 0; axis < state->joints_rad.size(); ++axis) {
    const double way_deg = degrees(state->joints_rad[axis] - state_.joints_rad[axis]);
    if (std::abs(way_deg) > standing_deg) moved_at_ = executor_.now();
  }
  state_ = *state;
  hear_state();
  return true;
}

// Why an arm that was asked to move does not.
Failure UniversalArm::trouble() const {
  if (local_) return {"not-in-control", "the pendant has control: the arm is in local control", {}, {}};
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
  if (!told_.known()) co_return told_.unknown();
  const Result<void> mode = co_await ask_mode();
  if (!mode) co_return mode;
  if (local_) co_return fail(trouble());
  for (const char* order : {"unlock protective stop\n", "power on\n", "brake release\n"}) {
    const Result<std::string> done = co_await dashboard_.ask(order);
    if (!done) co_return fail(done);
  }
  std::function<bool()> ready = [this] { return able(); };
  // An emergency stop is released by hand alone.
  const Duration patience = state_.safety_mode > 3 ? answer_time : power_time;
  const bool on = co_await told_.until(std::move(ready), patience);
  if (!on) co_return fail(trouble());
  co_return Result<void>();
}

Task<Result<void>> UniversalArm::release_control() {
  const Result<std::string> off = co_await dashboard_.ask("power off\n");
  if (!off) co_return fail(off);
  co_return Result<void>();
}

Task<Result<void>> UniversalArm::start_move(std::vector<Joints> waypoints, double speed) {
  const Result<void> sound = check_move(model_, waypoints, speed);
  if (!sound) co_return sound;
  if (!told_.known()) co_return told_.unknown();
  if (playing() && !ended()) co_return fail("busy", "the arm is moving already");
  if (!able()) co_return fail(trouble());
  ++programs_;
  stopping_ = false;
  const Joints from = joints();
  const std::vector<Leg> legs = legs_of(model_, from, waypoints);
  const Result<void> sent = script_.write(move_script(model_, legs, speed, from, 2 * programs_));
  if (!sent) co_return fail(sent);
  const std::int32_t begun = 2 * programs_;
  std::function<bool()> has_begun = [this, begun] { return state_.marker >= begun; };
  const bool begins = co_await told_.until(std::move(has_begun), answer_time);
  if (!begins) {
    const Failure why = trouble();
    // It may come late: it is not gone through in any case.
    [[maybe_unused]] const Result<void> ended = co_await stop();
    co_return fail(why);
  }
  co_return Result<void>();
}

Task<Result<void>> UniversalArm::stop() {
  constexpr std::string_view program = "def pizarra_stops():\n  stopj(8.0)\nend\n";
  stopping_ = true;
  const Result<void> told = script_.write(program);
  // A program is not acknowledged: where its line carries nothing any more, the other may.
  ending_ = executor_.spawn(end_program_too());
  if (told) co_return told;
  const Time deadline = executor_.now() + answer_time;
  const Result<void> open = co_await open_script(deadline);
  if (open) co_return script_.write(program);
  Result<void> ended = co_await end_program();
  co_return ended;
}

Task<Result<void>> UniversalArm::end_program() {
  line::Dialogue::Fits any = [](const std::string&) { return true; };
  const Result<std::string> ended = co_await dashboard_.ask_at_once("stop\n", std::move(any));
  if (!ended) co_return fail(ended);
  co_return Result<void>();
}

Task<void> UniversalArm::end_program_too() { [[maybe_unused]] const Result<void> ended = co_await end_program(); }

Task<Result<void>> UniversalArm::start_gripper(double opening_mm) {
  const Result<void> sound = check_opening(opening_mm);
  if (!sound) co_return sound;
  if (!told_.known()) co_return told_.unknown();
  if (!able()) co_return fail(trouble());
  line::OctetWriter input(line::ByteOrder::big);
  input.u8(input_recipe_).f64(opening_mm);
  gripping_until_ = executor_.now() + fresh;
  co_return rtde_.say(rtde::write(rtde::data, input.octets()));
}

Task<Result<ArmReading>> UniversalArm::read() {
  if (!told_.known()) co_return told_.unknown();
  const bool on_our_way = playing() && programs_ > 0 && !ended();
  if (!on_our_way && executor_.now() - mode_asked_at_ >= mode_time) {
    mode_asked_at_ = executor_.now();
    asking_mode_ = executor_.spawn(ask_mode_again());
  }
  ArmReading reading{.joints = joints(),
                     .moving = playing() || brakes(),
                     .stopped = !ended() && programs_ > 0,
                     .opening_mm = state_.opening_mm,
                     .gripper_moving = state_.fingers != 0 || executor_.now() < gripping_until_,
                     .at = told_.told_at()};
  if (!able() || local_) {
    using Kind = ArmTrouble::Kind;
    const bool fault = state_.safety_mode >= safety_violation;
    const bool off = state_.safety_mode <= 2 && !local_;
    reading.trouble = ArmTrouble{fault ? Kind::fault : off ? Kind::off : Kind::stopped, trouble()};
  }
  const bool unasked = reading.stopped && !stopping_ && !reading.moving;
  if (unasked) {
    reading.why_stopped = trouble();
    reading.why_stopped->symbol = "stopped";
  }
  co_return reading;
}

}  // namespace pizarra::arm
