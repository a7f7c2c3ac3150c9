#include "drivers/simulation/controllers/arms/ur_emulator.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

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

UrValue flange_at(const arm::ArmModel& model, const arm::Joints& joints) {
  const arm::ToolPose grip = arm::forward(model, joints);
  const Eigen::Vector3d place = (grip.translation() - model.tool_mm * grip.linear().col(2)) / 1000;
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(grip.linear()));
  const Eigen::Vector3d vector = turn.angle() * turn.axis();
  return {place.x(), place.y(), place.z(), vector.x(), vector.y(), vector.z()};
}

}  // namespace

void UrEmulator::run(std::string_view program) {
  if (!cabinet_.powered()) return;
  constexpr std::int32_t takes_no_programs = 210;
  if (cabinet_.pendant()) return messages_.say(ur_error_message(now_us(), takes_no_programs));
  if (!command(program)) programs_.run(program);
}

// Carries out words that are no program, but an order to the controller.
bool UrEmulator::command(std::string_view words) {
  while (!words.empty() && std::isspace(static_cast<unsigned char>(words.back())) != 0) words.remove_suffix(1);
  if (words == "power on") {
    power_.on();
  } else if (words == "power off") {
    power_.off();
  } else if (words == "set robotmode run") {
    power_.release_brakes();
  } else if (words == "set unlock protective stop") {
    static_cast<void>(cabinet_.reset());
  } else if (words == "stop program") {
    programs_.end_soon();
  } else {
    return false;
  }
  return true;
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
  state.numbers = values_.numbers();
  const auto tell = [&state](std::string_view name, double value) { state.numbers[std::string(name)] = value; };
  tell("timestamp", std::chrono::duration<double>(now.time_since_epoch()).count());
  tell("robot_mode", power_.mode());
  std::int32_t safety = safety_normal;
  if (cabinet_.alarm() != 0 || cabinet_.pendant_hold()) safety = safety_protective;
  if (cabinet_.emergency()) safety = safety_emergency;
  tell("safety_mode", safety);
  tell("safety_status", safety);
  constexpr std::uint32_t runtime[] = {1, arm::rtde::playing, 4};
  tell("runtime_state", runtime[static_cast<std::size_t>(programs_.phase())]);
  tell("robot_status_bits", (cabinet_.servo() ? 1 : 0) | (programs_.phase() == UrPrograms::Phase::playing ? 2 : 0));
  tell("safety_status_bits", safety == safety_normal ? 1 : safety == safety_protective ? 4 : 0x80);
  tell("speed_scaling", cabinet_.speed_override());
  tell("target_speed_fraction", cabinet_.speed_override());
  tell("actual_digital_output_bits", values_.outputs());
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
  const auto mask = values_.numbers().find("speed_slider_mask");
  if (mask == values_.numbers().end() || mask->second != 1) return;
  constexpr int slowest = 1;
  const int percent = std::clamp(static_cast<int>(std::lround(fraction * 100)), slowest, 100);
  static_cast<void>(cabinet_.obey("override " + std::to_string(percent)));
}

Task<std::string> UrEmulator::answer(std::string message) {
  if (message.empty() || !cabinet_.powered()) co_return std::string();
  if (message.front() != arm::rtde::data) co_return exchange_.answer(message);
  const std::vector<std::pair<std::string, double>> taken = exchange_.take(std::string_view(message).substr(1));
  for (const auto& each : taken) {
    values_.set(each.first, each.second);
    if (each.first == "speed_slider_fraction") set_speed_slider(each.second);
    if (each.first != arm::rtde::opening_name) continue;
    // The protocol answers nothing to this: fingers that may not move stay.
    [[maybe_unused]] const Refusal refusal = co_await cabinet_.grip(each.second);
  }
  // The mask may stand behind what it is of.
  for (const auto& each : taken) {
    constexpr std::string_view what = "_digital_output";
    const bool outputs = each.first.ends_with(what);
    if (outputs) values_.set_outputs(std::string_view(each.first).substr(0, each.first.size() - what.size()));
  }
  co_return std::string();
}

}  // namespace pizarra::simulation
