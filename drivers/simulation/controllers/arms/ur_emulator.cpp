#include "drivers/simulation/controllers/arms/ur_emulator.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "drivers/arm/kinematics.hpp"
#include "lisp/numbers.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::string_view fingers = "output_int_register_25";  // which the gripper's daemon writes
constexpr std::string_view opening = "output_double_register_24";
constexpr std::int32_t safety_normal = 1;
constexpr std::int32_t safety_protective = 3;
constexpr std::int32_t safety_emergency = 7;
constexpr double joint_running = 253;
constexpr double joint_off = 239;
constexpr double slowest_look_s = 0.008;  // how long speeds are measured for, at least
constexpr std::size_t most_said = 100;    // messages that nobody has taken yet

UrValue flange_at(const arm::ArmModel& model, const arm::Joints& joints) {
  const arm::ToolPose grip = arm::forward(model, joints);
  const Eigen::Vector3d place = (grip.translation() - model.tool_mm * grip.linear().col(2)) / 1000;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(grip.linear()));
  const Eigen::Vector3d vector = turn.angle() * turn.axis();
  return {place.x(), place.y(), place.z(), vector.x(), vector.y(), vector.z()};
}

}  // namespace

std::int32_t UrEmulator::robot_mode() const {
  if (cabinet_.servo()) return arm::rtde::running_mode;
  return energized_ && !cabinet_.emergency() ? ur_mode_idle : ur_mode_off;
}

void UrEmulator::switch_off() {
  energized_ = false;
  static_cast<void>(cabinet_.servo(false));
}

void UrEmulator::release_brakes() {
  energized_ = true;
  static_cast<void>(cabinet_.servo(true));
}

std::uint64_t UrEmulator::now_us() const {
  return static_cast<std::uint64_t>(
      std::chrono::duration_cast<std::chrono::microseconds>(executor_.now().time_since_epoch()).count());
}

void UrEmulator::say(std::string message) {
  if (said_.size() < most_said) said_.push_back(std::move(message));
}

std::string UrEmulator::take_said() {
  std::string all;
  for (const std::string& message : std::exchange(said_, {})) all += message;
  return all;
}

Task<UrState> UrEmulator::state() {
  const arm::ArmReading reading = co_await cabinet_.read();
  const Time now = executor_.now();
  UrState state;
  for (std::size_t axis = 0; axis < 4; ++axis) state.joints_rad[axis] = radians(reading.joints[axis]);
  state.joints_rad[4] = radians(-90);
  state.joints_rad[5] = radians(reading.joints[4]);
  const double since_s = std::chrono::duration<double>(now - told_at_).count();
  state.joints_rad_s = told_.joints_rad_s;
  for (std::size_t axis = 0; axis < 6 && since_s >= slowest_look_s; ++axis) {
    const double way = reading.moving ? state.joints_rad[axis] - told_.joints_rad[axis] : 0;
    state.joints_rad_s[axis] = way / since_s;
  }
  state.tool = flange_at(cabinet_.model(), reading.joints);
  state.joint_mode = cabinet_.servo() ? joint_running : joint_off;
  state.numbers = numbers_;
  const auto tell = [&state](std::string_view name, double value) { state.numbers[std::string(name)] = value; };
  tell("timestamp", std::chrono::duration<double>(now.time_since_epoch()).count());
  tell("robot_mode", robot_mode());
  std::int32_t safety = safety_normal;
  if (cabinet_.alarm() != 0 || cabinet_.pendant_hold()) safety = safety_protective;
  if (cabinet_.emergency()) safety = safety_emergency;
  tell("safety_mode", safety);
  tell("safety_status", safety);
  constexpr std::uint32_t runtime[] = {1, arm::rtde::playing, 4};
  tell("runtime_state", runtime[static_cast<std::size_t>(phase_)]);
  tell("robot_status_bits", (cabinet_.servo() ? 1 : 0) | (phase_ == Phase::playing ? 2 : 0));
  tell("safety_status_bits", safety == safety_normal ? 1 : safety == safety_protective ? 4 : 0x80);
  tell("speed_scaling", cabinet_.speed_override());
  tell("target_speed_fraction", cabinet_.speed_override());
  tell("actual_digital_output_bits", outputs_);
  if (reading.gripper_moving) tell(fingers, 1);
  tell(opening, reading.opening_mm);
  if (since_s >= slowest_look_s) {
    told_ = state;
    told_at_ = now;
  }
  co_return state;
}

// The pendant's slider, where the mask before it says that it is meant.
void UrEmulator::set_speed_slider(double fraction) {
  const auto mask = numbers_.find("speed_slider_mask");
  if (mask == numbers_.end() || mask->second != 1) return;
  constexpr int slowest = 1;
  const int percent = std::clamp(static_cast<int>(std::lround(fraction * 100)), slowest, 100);
  static_cast<void>(cabinet_.obey("override " + std::to_string(percent)));
}

// The digital outputs of a bank, those of them that the mask means.
void UrEmulator::set_outputs(std::string_view bank) {
  const std::string name(bank);
  const auto bits = [this](const std::string& field) {
    const auto found = numbers_.find(field);
    return found == numbers_.end() ? 0u : static_cast<std::uint32_t>(found->second);
  };
  const int first = bank == "configurable" ? 8 : bank == "tool" ? 16 : 0;
  const std::uint32_t mask = bits(name + "_digital_output_mask") << first;
  outputs_ = (outputs_ & ~mask) | (bits(name + "_digital_output") << first & mask);
}

Task<std::string> UrEmulator::answer(std::string message) {
  if (message.empty() || !cabinet_.powered()) co_return std::string();
  if (message.front() != arm::rtde::data) co_return exchange_.answer(message);
  const std::vector<std::pair<std::string, double>> taken = exchange_.take(std::string_view(message).substr(1));
  for (const auto& each : taken) {
    numbers_[each.first] = each.second;
    if (each.first == "speed_slider_fraction") set_speed_slider(each.second);
    if (each.first != arm::rtde::opening_name) continue;
    // The protocol answers nothing to this: fingers that may not move stay.
    [[maybe_unused]] const Refusal refusal = co_await cabinet_.grip(each.second);
  }
  // The mask may stand behind what it is of.
  for (const auto& each : taken) {
    constexpr std::string_view what = "_digital_output";
    const bool outputs = each.first.ends_with(what);
    if (outputs) set_outputs(std::string_view(each.first).substr(0, each.first.size() - what.size()));
  }
  co_return std::string();
}

}  // namespace pizarra::simulation
