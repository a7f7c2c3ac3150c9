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

constexpr std::string_view fingers = "output_int_register_25";  // which the gripper's daemon writes
constexpr std::string_view opening = "output_double_register_24";
constexpr std::int32_t mode_off = 3;
constexpr std::int32_t mode_idle = 5;
constexpr std::int32_t safety_normal = 1;
constexpr std::int32_t safety_protective = 3;
constexpr std::int32_t safety_emergency = 7;
constexpr std::uint32_t stopped = 1;
constexpr double joint_running = 253;
constexpr double joint_off = 239;
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

// The grip centre, where the flange is to be there: m and a rotation vector.
arm::ToolPose grip_of(const arm::ArmModel& model, const UrValue& pose) {
  arm::ToolPose grip = arm::ToolPose::Identity();
  const Eigen::Vector3d turn(pose[3], pose[4], pose[5]);
  if (turn.norm() > 0) grip.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
  grip.translation() = 1000 * Eigen::Vector3d(pose[0], pose[1], pose[2]) + model.tool_mm * grip.linear().col(2);
  return grip;
}

UrValue flange_at(const arm::ArmModel& model, const arm::Joints& joints) {
  const arm::ToolPose grip = arm::forward(model, joints);
  const Eigen::Vector3d place = (grip.translation() - model.tool_mm * grip.linear().col(2)) / 1000;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(grip.linear()));
  const Eigen::Vector3d vector = turn.angle() * turn.axis();
  return {place.x(), place.y(), place.z(), vector.x(), vector.y(), vector.z()};
}

// None where the arm cannot go there: wrist 2 stands, and axes have limits.
std::optional<arm::Joints> joints_of(const arm::ArmModel& model, const UrStep& step, const arm::Joints& near) {
  if (step.pose) {
    const Result<arm::Joints> joints = arm::inverse(model, grip_of(model, step.target), near);
    return joints ? std::optional(*joints) : std::nullopt;
  }
  const arm::Joints joints = five_of(step.target);
  const bool can = std::abs(arm::degrees(step.target[4]) + 90) <= 0.1 && arm::check_limits(model, joints);
  return can ? std::optional(joints) : std::nullopt;
}

}  // namespace

Task<std::string> UrEmulator::dashboard(std::string line) {
  const bool pendant = cabinet_.pendant();
  if (line == "is in remote control") co_return yes_no(!pendant);
  if (line == "get robot model") co_return model_name(cabinet_.model().type);
  if (line == "PolyscopeVersion") co_return software_of(cabinet_.model().type);
  if (line == "robotmode") co_return std::string(cabinet_.servo() ? "Robotmode: RUNNING" : "Robotmode: POWER_OFF");
  if (line == "running") co_return "Program running: " + yes_no(playing_);
  if (line == "programState") co_return program_state();
  if (line == "safetymode") co_return safety(false);
  if (line == "safetystatus") co_return safety(true);
  if (line == "get loaded program") co_return std::string("No program loaded");
  if (line == "get operational mode") co_return std::string(pendant ? "MANUAL" : "AUTOMATIC");
  if (line == "isProgramSaved") co_return std::string("true");
  if (line == "quit") co_return std::string("Disconnected");
  if (line.starts_with("addToLog ")) co_return std::string("Added log message");
  if (line.starts_with("popup ")) co_return std::string("showing popup");
  if (line == "close popup") co_return std::string("closing popup");
  if (line == "close safety popup") co_return std::string("closing safety popup");
  if (pendant) co_return "Command is not allowed due to: local control";
  if (line.starts_with("load ")) co_return "File not found: " + line.substr(5);
  if (line == "play" || line == "pause") co_return "Failed to execute: " + line;
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

std::string UrEmulator::program_state() const { return std::string(playing_ ? "PLAYING" : "STOPPED") + " <unnamed>"; }

// The mode, or the status, which names the emergency stop of the arm's own.
std::string UrEmulator::safety(bool status) const {
  const std::string what = status ? "Safetystatus: " : "Safetymode: ";
  if (cabinet_.emergency()) return what + "ROBOT_EMERGENCY_STOP";
  return what + (cabinet_.alarm() != 0 || cabinet_.pendant_hold() ? "PROTECTIVE_STOP" : "NORMAL");
}

void UrEmulator::run(std::string_view program) {
  Result<std::vector<UrStep>> steps = read_urscript(program);
  if (!steps || cabinet_.pendant() || !cabinet_.powered()) return;
  if (program.starts_with("sec ")) {
    for (const UrStep& step : *steps) set(step);
    return;
  }
  if (!cabinet_.servo()) return;
  program_ = executor_.spawn(carry_out(std::move(*steps)));
}

void UrEmulator::set(const UrStep& step) {
  if (step.kind == UrStep::Kind::set) numbers_[step.field] = step.value;
  if (step.kind != UrStep::Kind::digital_output) return;
  const std::uint32_t bit = 1u << step.number;
  outputs_ = step.value != 0 ? outputs_ | bit : outputs_ & ~bit;
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
    } else if (step.kind == UrStep::Kind::sleep) {
      const auto pause = std::chrono::duration_cast<Duration>(std::chrono::duration<double>(step.value));
      co_await sleep(executor_, pause);
    } else {
      set(step);
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
    const std::optional<arm::Joints> there = joints_of(model, step, at);
    if (!there) co_return false;
    const arm::Joints& to = *there;
    if (step.kind == UrStep::Kind::move_line) {
      const arm::ToolPose end = arm::forward(model, to);
      const double mm = (end.translation() - arm::forward(model, at).translation()).norm();
      const double mm_s = step.time_s > 0 ? mm / step.time_s : step.speed * 1000;
      if (mm_s <= 0) continue;
      const Result<StraightWay> way = straight_way(model, at, end, mm_s);
      if (!way) co_return false;
      waypoints.insert(waypoints.end(), way->waypoints.begin(), way->waypoints.end());
      part = std::min(part, way->part);
    } else {
      double furthest = 0;
      for (std::size_t axis = 0; axis < to.size(); ++axis) furthest = std::max(furthest, std::abs(to[axis] - at[axis]));
      const double wanted_s = step.time_s > 0 ? step.time_s : arm::radians(furthest) / step.speed;
      if (wanted_s > 0) part = std::min(part, std::max(1e-3, arm::seconds_between(model, at, to) / wanted_s));
    }
    waypoints.push_back(to);
    at = to;
  }
  if (waypoints.empty()) co_return true;
  const Refusal refusal = co_await cabinet_.move(std::move(waypoints), part);
  if (refusal != Refusal::none) co_return false;
  arm::ArmReading reading = co_await cabinet_.read();
  while (reading.moving) {
    co_await sleep(executor_, look_again);
    reading = co_await cabinet_.read();
  }
  co_return !reading.stopped;
}

Task<UrState> UrEmulator::state() {
  const arm::ArmReading reading = co_await cabinet_.read();
  const Time now = executor_.now();
  UrState state;
  for (std::size_t axis = 0; axis < 4; ++axis) state.joints_rad[axis] = arm::radians(reading.joints[axis]);
  state.joints_rad[4] = arm::radians(-90);
  state.joints_rad[5] = arm::radians(reading.joints[4]);
  const double since_s = std::chrono::duration<double>(now - told_at_).count();
  for (std::size_t axis = 0; axis < 6 && reading.moving && since_s > 0; ++axis) {
    state.joints_rad_s[axis] = (state.joints_rad[axis] - told_.joints_rad[axis]) / since_s;
  }
  state.tool = flange_at(cabinet_.model(), reading.joints);
  state.joint_mode = cabinet_.servo() ? joint_running : joint_off;
  state.numbers = numbers_;
  const auto tell = [&state](std::string_view name, double value) { state.numbers[std::string(name)] = value; };
  tell("timestamp", std::chrono::duration<double>(now.time_since_epoch()).count());
  tell("robot_mode", cabinet_.servo() ? arm::rtde::running_mode : cabinet_.emergency() ? mode_off : mode_idle);
  std::int32_t safety = safety_normal;
  if (cabinet_.alarm() != 0 || cabinet_.pendant_hold()) safety = safety_protective;
  if (cabinet_.emergency()) safety = safety_emergency;
  tell("safety_mode", safety);
  tell("safety_status", safety);
  tell("runtime_state", playing_ ? arm::rtde::playing : stopped);
  tell("robot_status_bits", (cabinet_.servo() ? 1 : 0) | (playing_ ? 2 : 0));
  tell("safety_status_bits", safety == safety_normal ? 1 : safety == safety_protective ? 4 : 0x80);
  tell("speed_scaling", cabinet_.speed_override());
  tell("target_speed_fraction", cabinet_.speed_override());
  tell("actual_digital_output_bits", outputs_);
  if (reading.gripper_moving) tell(fingers, 1);
  tell(opening, reading.opening_mm);
  told_ = state;
  told_at_ = now;
  co_return state;
}

Task<std::string> UrEmulator::answer(std::string message) {
  if (message.empty() || !cabinet_.powered()) co_return std::string();
  if (message.front() != arm::rtde::data) co_return exchange_.answer(message);
  const std::vector<std::pair<std::string, double>> taken = exchange_.take(std::string_view(message).substr(1));
  for (const auto& each : taken) {
    numbers_[each.first] = each.second;
    if (each.first != arm::rtde::opening_name) continue;
    // The protocol answers nothing to this: fingers that may not move stay.
    [[maybe_unused]] const Refusal refusal = co_await cabinet_.grip(each.second);
  }
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
  std::optional<Duration> paced;
  while (true) {
    const std::optional<Duration> every = emulator.told_every();
    // Another client may want it at another rate.
    if (every != paced) pace.reset();
    paced = every;
    if (!every) {
      co_await sleep(executor, client_pause);
      continue;
    }
    if (!pace) pace.emplace(executor, *every);
    const Duration pause = pace->pause();
    co_await sleep(executor, pause);
    const UrState state = co_await emulator.state();
    // Nobody reads, or it has no power: what is not told is lost. It may have been paused meanwhile.
    if (emulator.told_every()) static_cast<void>(port.write(emulator.tell(state)));
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

// A program of several lines ends with the line `end`.
Task<void> serve_script(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  std::string program;
  FrameService service{.reader = line::frame_of_line};
  service.greet = [&program] {
    program.clear();
    return std::string();
  };
  service.answer = [&](std::string line) {
    const bool begins = line.starts_with("def ") || line.starts_with("sec ");
    const bool within = begins || !program.empty();
    program += line + "\n";
    if (!within || line == "end") emulator.run(std::exchange(program, {}));
    if (program.size() > longest_program) program.clear();
    return nothing();
  };
  co_await serve_frames(executor, std::move(service), port);
}

Task<void> serve_dashboard(Executor& executor, UrEmulator& emulator, line::ByteWire& port) {
  FrameService service{.reader = line::frame_of_line};
  service.greet = [] { return std::string("Connected: Universal Robots Dashboard Server\n"); };
  service.answer = [&emulator](std::string line) { return answer_line(emulator, std::move(line)); };
  service.last = [](std::string_view line) { return line == "quit"; };
  co_await serve_frames(executor, std::move(service), port);
}

}  // namespace pizarra::simulation
