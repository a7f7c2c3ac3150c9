#include "drivers/simulation/controllers/arms/ur_emulator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "blackboard/time/pace.hpp"
#include "drivers/arm/angles.hpp"
#include "drivers/arm/route.hpp"
#include "drivers/simulation/controllers/arms/serve_frames.hpp"
#include "drivers/simulation/controllers/arms/straight_way.hpp"

namespace pizarra::simulation {

namespace {

constexpr int marker = 24;   // integer registers
constexpr int fingers = 25;  // which the gripper's daemon writes
constexpr std::int32_t mode_off = 3;
constexpr std::int32_t mode_idle = 5;
constexpr std::int32_t safety_normal = 1;
constexpr std::int32_t safety_protective = 3;
constexpr std::int32_t safety_emergency = 7;
constexpr std::uint32_t stopped = 1;
constexpr std::uint8_t recipe = 1;
constexpr std::size_t longest_program = 1 << 20;
constexpr Duration client_pause = 10ms;  // until it is looked again for one that wants to be told

arm::Joints five_of(const std::array<double, 6>& q) {
  return {arm::degrees(q[0]), arm::degrees(q[1]), arm::degrees(q[2]), arm::degrees(q[3]), arm::degrees(q[5])};
}

bool is_move(const UrStep& step) {
  return step.kind == UrStep::Kind::move_joints || step.kind == UrStep::Kind::move_line;
}

std::string yes_no(bool value) { return value ? "true" : "false"; }

// Of a UR5e too it says UR5.
std::string model_name(std::string type) {
  std::ranges::transform(type, type.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  if (type.ends_with('E')) type.pop_back();
  return type;
}

std::string software_of(std::string_view type) {
  return type.ends_with('e') ? "URSoftware 5.11.0.108249 (Jan 01 2021)" : "URSoftware 3.15.0.106331 (Jan 01 2021)";
}

std::string octet(std::uint8_t value) { return std::string(1, static_cast<char>(value)); }

}  // namespace

Task<std::string> UrEmulator::dashboard(std::string line) {
  const bool pendant = cabinet_.pendant();
  if (line == "is in remote control") co_return yes_no(!pendant);
  if (line == "get robot model") co_return model_name(cabinet_.model().type);
  if (line == "PolyscopeVersion") co_return software_of(cabinet_.model().type);
  if (line == "robotmode") co_return std::string(cabinet_.servo() ? "Robotmode: RUNNING" : "Robotmode: POWER_OFF");
  if (line == "running") co_return "Program running: " + yes_no(playing_);
  if (pendant) co_return "Command is not allowed due to: local control";
  if (line == "power on") co_return std::string("Powering on");
  if (line == "power off") {
    static_cast<void>(cabinet_.servo(false));
    co_return std::string("Powering off");
  }
  if (line == "brake release") {
    static_cast<void>(cabinet_.servo(true));
    co_return std::string("Brake releasing");
  }
  if (line == "unlock protective stop") {
    static_cast<void>(cabinet_.reset());
    co_return std::string("Protective stop releasing");
  }
  if (line == "stop") {
    program_ = Job();
    playing_ = false;
    co_await cabinet_.stop();
    co_return std::string("Stopped");
  }
  co_return "could not understand: " + line;
}

void UrEmulator::run(std::string_view program) {
  Result<std::vector<UrStep>> steps = read_urscript(program);
  if (!steps || cabinet_.pendant() || !cabinet_.servo() || !cabinet_.powered()) return;
  program_ = executor_.spawn(carry_out(std::move(*steps)));
}

Task<void> UrEmulator::carry_out(std::vector<UrStep> steps) {
  playing_ = true;
  // What the program before had begun ends first.
  arm::ArmReading reading = co_await cabinet_.read();
  if (reading.moving) co_await cabinet_.stop();
  while (reading.moving) {
    co_await sleep(executor_, look_again);
    reading = co_await cabinet_.read();
  }
  bool goes_on = true;
  for (std::size_t i = 0; i < steps.size() && goes_on; ++i) {
    const UrStep& step = steps[i];
    if (is_move(step)) {
      std::size_t end = i;
      while (end < steps.size() && is_move(steps[end])) ++end;
      std::vector<UrStep> moves(steps.begin() + static_cast<std::ptrdiff_t>(i),
                                steps.begin() + static_cast<std::ptrdiff_t>(end));
      goes_on = co_await move(std::move(moves));
      i = end - 1;
    } else if (step.kind == UrStep::Kind::write_register) {
      registers_[step.number] = static_cast<std::int32_t>(step.value);
    } else if (step.kind == UrStep::Kind::sleep) {
      const auto pause = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(step.value));
      co_await sleep(executor_, pause);
    }
  }
  playing_ = false;
}

// Moves that follow one another are blended into one. False where the arm did not get there.
Task<bool> UrEmulator::move(std::vector<UrStep> moves) {
  const arm::ArmModel& model = cabinet_.model();
  const arm::ArmReading before = co_await cabinet_.read();
  std::vector<arm::Joints> waypoints;
  arm::Joints at = before.joints;
  double part = 1;
  for (const UrStep& step : moves) {
    const arm::Joints to = five_of(step.joints_rad);
    if (std::abs(arm::degrees(step.joints_rad[4]) + 90) > 0.1 || !arm::check_limits(model, to)) co_return false;
    if (step.kind == UrStep::Kind::move_line) {
      const Result<StraightWay> way = straight_way(model, at, arm::forward(model, to), step.speed * 1000);
      if (!way) co_return false;
      waypoints.insert(waypoints.end(), way->waypoints.begin(), way->waypoints.end());
      part = std::min(part, way->part);
    } else {
      double furthest = 0;
      for (std::size_t axis = 0; axis < to.size(); ++axis) furthest = std::max(furthest, std::abs(to[axis] - at[axis]));
      const double wanted_s = arm::radians(furthest) / step.speed;
      if (wanted_s > 0) part = std::min(part, std::max(1e-3, arm::seconds_between(model, at, to) / wanted_s));
    }
    waypoints.push_back(to);
    at = to;
  }
  const Refusal refusal = co_await cabinet_.move(std::move(waypoints), part);
  if (refusal != Refusal::none) co_return false;
  arm::ArmReading reading = co_await cabinet_.read();
  while (reading.moving) {
    co_await sleep(executor_, look_again);
    reading = co_await cabinet_.read();
  }
  co_return !reading.stopped;
}

Task<arm::rtde::State> UrEmulator::state() {
  const arm::ArmReading reading = co_await cabinet_.read();
  arm::rtde::State state;
  for (std::size_t axis = 0; axis < 4; ++axis) state.joints_rad[axis] = arm::radians(reading.joints[axis]);
  state.joints_rad[4] = arm::radians(-90);
  state.joints_rad[5] = arm::radians(reading.joints[4]);
  state.robot_mode = cabinet_.servo() ? arm::rtde::running_mode : cabinet_.emergency() ? mode_off : mode_idle;
  state.safety_mode = safety_normal;
  if (cabinet_.alarm() != 0 || cabinet_.pendant_hold()) state.safety_mode = safety_protective;
  if (cabinet_.emergency()) state.safety_mode = safety_emergency;
  state.runtime = playing_ ? arm::rtde::playing : stopped;
  const auto register_of = [&](int number) {
    const auto found = registers_.find(number);
    return found == registers_.end() ? 0 : found->second;
  };
  state.marker = register_of(marker);
  state.fingers = reading.gripper_moving ? 1 : register_of(fingers);
  state.opening_mm = reading.opening_mm;
  co_return state;
}

std::string UrEmulator::accept(char type, line::OctetReader& read) {
  if (type == arm::rtde::version) return arm::rtde::write(type, octet(read.u16() == 2 ? 1 : 0));
  if (type == arm::rtde::start) {
    telling_ = true;
    return arm::rtde::write(type, octet(1));
  }
  if (type == arm::rtde::inputs) {
    const bool known = read.rest() == arm::rtde::opening_name;
    return arm::rtde::write(type, known ? octet(recipe) + "DOUBLE" : octet(0) + "NOT_FOUND");
  }
  if (type != arm::rtde::outputs) return "";
  const double per_s = read.f64();
  if (!(per_s >= 1 && per_s <= 500) || read.rest() != arm::rtde::state_names) {
    return arm::rtde::write(type, octet(0) + "NOT_FOUND");
  }
  period_ = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(1 / per_s));
  return arm::rtde::write(type, octet(recipe) + std::string(arm::rtde::state_types));
}

Task<std::string> UrEmulator::answer(std::string message) {
  if (message.empty() || !cabinet_.powered()) co_return std::string();
  line::OctetReader read(std::string_view(message).substr(1), line::ByteOrder::big);
  if (message.front() != arm::rtde::data) co_return accept(message.front(), read);
  const std::uint8_t which = read.u8();
  const double opening_mm = read.f64();
  const bool sound = which == recipe && read.whole() && std::isfinite(opening_mm);
  // The protocol answers nothing to this: fingers that may not move stay.
  if (sound) [[maybe_unused]]
    const Refusal refusal = co_await cabinet_.grip(opening_mm);
  co_return std::string();
}

namespace {

Task<std::string> nothing() { co_return std::string(); }

Task<std::string> answer_line(UrEmulator& emulator, std::string line) {
  std::string answer = co_await emulator.dashboard(std::move(line));
  co_return answer + "\n";
}

Task<void> tell_states(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  std::optional<Pace> pace;
  while (true) {
    const std::optional<Duration> every = emulator.told_every();
    if (!every) {
      co_await sleep(executor, client_pause);
      pace.reset();
      continue;
    }
    if (!pace) pace.emplace(executor, *every);
    const Duration pause = pace->pause();
    co_await sleep(executor, pause);
    const arm::rtde::State state = co_await emulator.state();
    // Nobody reads, or it has no power: what is not told is lost.
    static_cast<void>(port.write(arm::rtde::write(arm::rtde::data, arm::rtde::write_state(recipe, state))));
  }
}

}  // namespace

Task<void> serve_rtde(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  const Job telling = executor.spawn(tell_states(executor, emulator, port));
  FrameService service{.reader = arm::rtde::frame};
  service.greet = [&emulator] {
    emulator.forget_client();
    return std::string();
  };
  service.answer = [&emulator](std::string message) { return emulator.answer(std::move(message)); };
  co_await serve_frames(executor, std::move(service), port);
}

// A program ends with the line `end`.
Task<void> serve_script(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  std::string program;
  FrameService service{.reader = line::frame_of_line};
  service.greet = [&program] {
    program.clear();
    return std::string();
  };
  service.answer = [&](std::string line) {
    program += line + "\n";
    if (line == "end") emulator.run(std::exchange(program, {}));
    if (program.size() > longest_program) program.clear();
    return nothing();
  };
  co_await serve_frames(executor, std::move(service), port);
}

Task<void> serve_dashboard(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  FrameService service{.reader = line::frame_of_line};
  service.greet = [] { return std::string("Connected: Universal Robots Dashboard Server\n"); };
  service.answer = [&emulator](std::string line) { return answer_line(emulator, std::move(line)); };
  co_await serve_frames(executor, std::move(service), port);
}

}  // namespace pizarra::simulation
