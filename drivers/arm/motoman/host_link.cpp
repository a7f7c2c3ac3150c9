#include "drivers/arm/motoman/host_link.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

#include "drivers/line/printable.hpp"

namespace pizarra::arm {

namespace {

constexpr std::size_t robot_axes = 6;
constexpr std::size_t most_axes_told = 12;  // with the external ones
constexpr int base_frame = 0;
constexpr int double_integer = 2;
constexpr std::string_view no_external_axes = "0,0,0,0,0,0";

// Failure: bad-reply, which names what it is of.
Result<std::int32_t> whole_number(double value, const std::string& of) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  if (value == std::floor(value) && std::abs(value) <= most) return static_cast<std::int32_t>(value);
  return fail("bad-reply", fmt::format("the controller says {} of {}, which must be a whole number", value, of),
              to_datum(of));
}

}  // namespace

Task<Result<std::vector<double>>> HostLink::ask(std::string name, std::string operands, std::size_t count) {
  HostCommand question{name, std::move(operands)};
  const Result<std::string> data = co_await line_.command(std::move(question));
  if (!data) co_return fail(data);
  std::optional<std::vector<double>> numbers = numbers_in(*data);
  if (!numbers || numbers->size() < count) {
    co_return fail("bad-reply", fmt::format("the controller answered {} with '{}' instead of {} numbers", name,
                                            line::printable(*data), count));
  }
  co_return std::move(*numbers);
}

Task<Result<void>> HostLink::order(std::string name, std::string operands, HostCommand::Kind kind) {
  HostCommand command{std::move(name), std::move(operands), kind};
  const Result<std::string> done = co_await line_.command(std::move(command));
  if (!done) co_return fail(done);
  co_return Result<void>();
}

Task<Result<MotomanStatus>> HostLink::status() {
  const Result<std::vector<double>> words = co_await ask("RSTATS", "", 2);
  if (!words) co_return fail(words);
  const Result<std::int32_t> modes = whole_number((*words)[0], "RSTATS 1");
  if (!modes) co_return fail(modes);
  const Result<std::int32_t> states = whole_number((*words)[1], "RSTATS 2");
  if (!states) co_return fail(states);
  co_return motoman_status(static_cast<std::uint32_t>(*modes), static_cast<std::uint32_t>(*states));
}

// An error's code and data come first, then those of up to four alarms.
Task<Result<std::uint32_t>> HostLink::alarm_code() {
  const Result<std::vector<double>> codes = co_await ask("RALARM", "", 4);
  if (!codes) co_return fail(codes);
  const Result<std::int32_t> code = whole_number((*codes)[0] != 0 ? (*codes)[0] : (*codes)[2], "RALARM");
  if (!code) co_return fail(code);
  co_return static_cast<std::uint32_t>(*code);
}

Task<Result<MotomanPulses>> HostLink::pulses() {
  const Result<std::vector<double>> told = co_await ask("RPOSJ", "", robot_axes);
  if (!told) co_return fail(told);
  if (told->size() > most_axes_told) co_return fail("bad-reply", "the controller tells more than 12 axes");
  MotomanPulses pulses{};
  for (std::size_t axis = 0; axis < std::min(told->size(), pulses.size()); ++axis) {
    const Result<std::int32_t> count = whole_number((*told)[axis], fmt::format("axis {}", axis + 1));
    if (!count) co_return fail("bad-reply", count.error().sentence, to_datum(axis + 1));
    pulses[axis] = *count;
  }
  co_return pulses;
}

Task<Result<MotomanPose>> HostLink::pose() {
  const Result<std::vector<double>> told = co_await ask("RPOSC", fmt::format("{},0", base_frame), 8);
  if (!told) co_return fail(told);
  MotomanPose pose;
  std::copy_n(told->begin(), 3, pose.place_mm.begin());
  std::copy_n(told->begin() + 3, 3, pose.angles_deg.begin());
  const Result<std::int32_t> form = whole_number((*told)[6], "the type of its pose");
  if (!form) co_return fail(form);
  const Result<std::int32_t> tool = whole_number((*told)[7], "its tool");
  if (!tool) co_return fail(tool);
  pose.form = static_cast<std::uint32_t>(*form);
  pose.tool = static_cast<std::uint32_t>(*tool);
  co_return pose;
}

Task<Result<void>> HostLink::turn(MotomanSwitch which, bool on) {
  if (which == MotomanSwitch::servo) return order("SVON", on ? "1" : "0");
  return order("HOLD", on ? "1" : "0", on ? HostCommand::Kind::stop : HostCommand::Kind::order);
}

Task<Result<void>> HostLink::reset() {
  const Result<void> alarm = co_await order("RESET", "");
  if (!alarm) co_return alarm;
  const Result<void> error = co_await order("CANCEL", "");
  co_return error;
}

Task<Result<void>> HostLink::move_joints(MotomanPulses target, double part) {
  std::string operands = fmt::format("{:.2f}", std::clamp(part * 100, 0.01, 100.0));
  for (std::size_t axis = 0; axis < robot_axes; ++axis) operands += fmt::format(",{}", target[axis]);
  return order("PMOVJ", fmt::format("{},{},0", operands, no_external_axes), HostCommand::Kind::motion);
}

Task<Result<void>> HostLink::move_straight(MotomanPose target, double mm_s) {
  const auto& [x, y, z] = target.place_mm;
  const auto& [rx, ry, rz] = target.angles_deg;
  std::string operands =
      fmt::format("0,{:.1f},{},{:.3f},{:.3f},{:.3f},{:.4f},{:.4f},{:.4f},{},{},{}", std::max(0.1, mm_s), base_frame, x,
                  y, z, rx, ry, rz, target.form, target.tool, no_external_axes);
  return order("MOVL", std::move(operands), HostCommand::Kind::motion);
}

Task<Result<std::int32_t>> HostLink::variable(int number) {
  const Result<std::vector<double>> value = co_await ask("SAVEV", fmt::format("{},{}", double_integer, number), 1);
  if (!value) co_return fail(value);
  co_return whole_number(value->front(), fmt::format("variable D{:03}", number));
}

Task<Result<void>> HostLink::set_variable(int number, std::int32_t value) {
  return order("LOADV", fmt::format("{},{},{}", double_integer, number, value));
}

}  // namespace pizarra::arm
