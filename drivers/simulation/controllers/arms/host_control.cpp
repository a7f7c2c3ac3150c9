#include "drivers/simulation/controllers/arms/host_control.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <limits>

#include "drivers/arm/motoman/host_command.hpp"
#include "drivers/arm/motoman/refusal_codes.hpp"

namespace pizarra::simulation {

namespace {

constexpr std::size_t robot_axes = 6;
constexpr double double_integer = 2;  // the type of D variables
constexpr double base_frame = 0;
constexpr double robot_frame = 1;  // the same, without a base axis

bool is_whole(double value, double low, double high) {
  return value == std::floor(value) && value >= low && value <= high;
}

bool is_switch(double value) { return value == 0 || value == 1; }

bool is_pulses(double value) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  return is_whole(value, -most, most);
}

HostAnswer refused(Refusal refusal) { return {.refusal = motoman_code(refusal)}; }

const HostAnswer wrong_value{.refusal = arm::motoman::wrong_value};

}  // namespace

std::string host_code(std::uint16_t refusal) { return fmt::format("{:04X}", refusal); }

const HostControl::Command HostControl::commands[] = {
    {"RSTATS", 0, &HostControl::status},       {"RALARM", 0, &HostControl::alarms},
    {"RPOSJ", 0, &HostControl::pulses},        {"RPOSC", 2, &HostControl::pose},
    {"SVON", 1, &HostControl::servo},          {"HOLD", 1, &HostControl::hold},
    {"RESET", 0, &HostControl::reset},         {"CANCEL", 0, &HostControl::cancel},
    {"PMOVJ", 14, &HostControl::move_pulses},  {"MOVL", 17, &HostControl::move_line},
    {"SAVEV", 2, &HostControl::save_variable}, {"LOADV", 3, &HostControl::load_variable},
};

Task<HostAnswer> HostControl::carry_out(std::string name, std::string operands) {
  HostAnswer answer;
  const auto* const found = std::ranges::find(commands, name, &Command::name);
  std::optional<Numbers> numbers = arm::numbers_in(operands);
  const bool none = operands.find_first_not_of(" \r\n") == std::string::npos;
  if (none) numbers.emplace();
  if (found == std::end(commands)) {
    answer.refusal = arm::motoman::unknown_command;
  } else if (!numbers) {
    answer.refusal = arm::motoman::wrong_value;
  } else if (numbers->size() != found->operands) {
    answer.refusal = arm::motoman::wrong_count;
  } else {
    answer = co_await (this->*found->carry_out)(std::move(*numbers));
  }
  co_return answer;
}

Task<HostAnswer> HostControl::status(Numbers) {
  const MotomanController::Words words = co_await controller_.status();
  HostAnswer answer;
  answer.data = fmt::format("{},{}", words.modes, words.states);
  co_return answer;
}

// An error, which it never has, and up to four alarms, each with its data.
Task<HostAnswer> HostControl::alarms(Numbers) {
  HostAnswer answer;
  answer.data = fmt::format("0,0,{},0,0,0,0,0,0,0", controller_.cabinet().alarm());
  co_return answer;
}

Task<HostAnswer> HostControl::pulses(Numbers) {
  const arm::MotomanPulses pulses = co_await controller_.pulses();
  HostAnswer answer;
  answer.data = fmt::format("{},0,0,0,0,0,0", fmt::join(pulses.begin(), pulses.begin() + robot_axes, ","));
  co_return answer;
}

Task<HostAnswer> HostControl::pose(Numbers operands) {
  const bool known = operands[0] == base_frame || operands[0] == robot_frame;
  if (!known) co_return wrong_value;
  const arm::MotomanPose pose = co_await controller_.pose();
  HostAnswer answer;
  answer.data = fmt::format("{:.3f},{:.4f},{},{}", fmt::join(pose.place_mm, ","), fmt::join(pose.angles_deg, ","),
                            pose.form, pose.tool);
  co_return answer;
}

Task<HostAnswer> HostControl::servo(Numbers operands) {
  if (!is_switch(operands[0])) co_return wrong_value;
  const Refusal refusal = controller_.cabinet().servo(operands[0] == 1);
  HostAnswer answer = refused(refusal);
  if (refusal == Refusal::emergency) answer.refusal = arm::motoman::servo_refused;
  co_return answer;
}

Task<HostAnswer> HostControl::hold(Numbers operands) {
  if (!is_switch(operands[0])) co_return wrong_value;
  co_return refused(controller_.cabinet().hold(operands[0] == 1));
}

Task<HostAnswer> HostControl::reset(Numbers) { co_return refused(controller_.cabinet().reset()); }

Task<HostAnswer> HostControl::cancel(Numbers) { co_return HostAnswer(); }

// Speed in percent, the robot's axes, external ones, tool.
Task<HostAnswer> HostControl::move_pulses(Numbers operands) {
  const bool sound =
      operands[0] > 0 && operands[0] <= 100 && std::all_of(operands.begin() + 1, operands.end(), is_pulses);
  if (!sound) co_return wrong_value;
  arm::MotomanPulses target{};
  for (std::size_t axis = 0; axis < robot_axes; ++axis) target[axis] = static_cast<std::int32_t>(operands[axis + 1]);
  const Refusal refusal = co_await controller_.move_joints(target, operands[0] / 100);
  co_return refused(refusal);
}

// The operands: the kind of speed, the speed, the frame, place and angles, form, tool, external axes.
Task<HostAnswer> HostControl::move_line(Numbers operands) {
  const bool sound =
      operands[0] == 0 && operands[1] >= 0.1 && (operands[2] == base_frame || operands[2] == robot_frame);
  if (!sound) co_return wrong_value;
  arm::MotomanPose target;
  std::copy_n(operands.begin() + 3, 3, target.place_mm.begin());
  std::copy_n(operands.begin() + 6, 3, target.angles_deg.begin());
  const Refusal refusal = co_await controller_.move_straight(target, operands[1]);
  co_return refused(refusal);
}

Task<HostAnswer> HostControl::save_variable(Numbers operands) {
  const bool known = operands[0] == double_integer && is_whole(operands[1], 0, MotomanController::variables - 1);
  if (!known) co_return wrong_value;
  const std::int32_t value = co_await controller_.variable(static_cast<int>(operands[1]));
  HostAnswer answer;
  answer.data = fmt::format("{}", value);
  co_return answer;
}

Task<HostAnswer> HostControl::load_variable(Numbers operands) {
  const bool known = operands[0] == double_integer && is_whole(operands[1], 0, MotomanController::variables - 1);
  const bool sound = known && is_pulses(operands[2]);
  if (!sound) co_return wrong_value;
  const auto value = static_cast<std::int32_t>(operands[2]);
  const Refusal refusal = co_await controller_.set_variable(static_cast<int>(operands[1]), value);
  co_return refused(refusal);
}

}  // namespace pizarra::simulation
