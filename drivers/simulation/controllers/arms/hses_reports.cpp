#include "drivers/simulation/controllers/arms/hses_reports.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

#include "drivers/arm/motoman/refusal_codes.hpp"
#include "drivers/line/octets.hpp"
#include "drivers/simulation/controllers/arms/hses_codes.hpp"

namespace pizarra::simulation {

namespace {

constexpr double units_per_deg = 10'000;

std::string word(std::uint32_t value) { return line::OctetWriter(line::ByteOrder::little).u32(value).octets(); }

std::string words(std::size_t count) { return std::string(4 * count, '\0'); }

std::string text(std::string_view said, std::size_t octets) {
  std::string field(said.substr(0, octets));
  field.resize(octets, '\0');
  return field;
}

std::int32_t rounded(double value) { return static_cast<std::int32_t>(std::llround(value)); }

// Code, data, type, time and name.
std::vector<std::string> alarm_elements(int code) {
  return {word(static_cast<std::uint32_t>(code)), word(0), word(0), text("", 16),
          text(code == 0 ? std::string() : fmt::format("ALARM {}", code), 32)};
}

bool is_robot(std::uint16_t instance) {
  return instance == arm::hses::robot_pulses || instance == arm::hses::robot_base;
}

}  // namespace

Task<HsesOutcome> HsesReports::status(arm::HsesRequest request) const {
  const MotomanController::Words status_words = co_await controller_.status();
  constexpr std::uint32_t runs = 8;
  const std::uint32_t modes = status_words.modes | (jobs_.runs() ? runs : 0);
  const std::vector<std::string> elements{word(modes), word(status_words.states)};
  HsesOutcome outcome;
  outcome.refusal = arm::hses::wrong_instance;
  if (request.instance == 1) outcome = hses_elements(request, elements);
  co_return outcome;
}

Task<HsesOutcome> HsesReports::position(arm::HsesRequest request) const {
  HsesOutcome outcome;
  outcome.refusal = arm::hses::wrong_instance;
  if (!is_robot(request.instance)) co_return outcome;
  const bool in_base = request.instance == arm::hses::robot_base;
  arm::MotomanPulses axes = co_await controller_.pulses();
  if (in_base) {
    const arm::MotomanPose pose = co_await controller_.pose();
    axes = {};
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i] = rounded(pose.place_mm[i] * arm::um_per_mm);
      axes[i + 3] = rounded(pose.angles_deg[i] * units_per_deg);
    }
  }
  // Type, form, tool, user frame and extended form before them.
  std::vector<std::string> elements{word(in_base ? arm::hses::base_frame : 0), word(0), word(0), word(0), word(0)};
  for (const std::int32_t axis : axes) elements.push_back(word(static_cast<std::uint32_t>(axis)));
  co_return hses_elements(request, elements);
}

// The alarms there are now, four at most, or those there were: in groups of a hundred, by how bad they are.
HsesOutcome HsesReports::alarm(const arm::HsesRequest& request) const {
  constexpr std::uint16_t now_at_most = 4;
  constexpr std::uint16_t group = 1000;
  constexpr std::uint16_t groups = 5;
  constexpr std::uint16_t group_size = 100;
  const std::uint16_t number = request.command == arm::hses::alarm ? request.instance : request.instance % group;
  const std::uint16_t most = request.command == arm::hses::alarm ? now_at_most : group_size;
  if (number < 1 || number > most || request.instance >= groups * group) {
    return {.refusal = arm::hses::wrong_instance};
  }
  if (request.command == arm::hses::alarm)
    return hses_elements(request, alarm_elements(number == 1 ? cabinet_.alarm() : 0));
  constexpr int first_minor = 1000;
  std::vector<int> codes;
  for (const int code : cabinet_.past_alarms()) {
    const int its_group = code < first_minor ? 0 : 1;
    if (its_group == request.instance / group) codes.push_back(code);
  }
  return hses_elements(request, alarm_elements(number <= codes.size() ? codes[codes.size() - number] : 0));
}

HsesOutcome HsesReports::report(const arm::HsesRequest& request) const {
  constexpr std::size_t axes = 8;
  std::vector<std::string> elements;
  if (request.command == hses::executing_job) {
    constexpr double whole = 10'000;
    constexpr std::uint16_t tasks = 6;
    if (request.instance < 1 || request.instance > tasks) return {.refusal = arm::hses::wrong_instance};
    elements = {text(jobs_.name(), 32), word(jobs_.line()), word(0),
                word(static_cast<std::uint32_t>(cabinet_.speed_override() * whole))};
  } else if (request.command == hses::system_information) {
    constexpr std::uint16_t robot = 11;
    constexpr std::uint16_t application = 101;
    if (request.instance != robot && request.instance != application) return {.refusal = arm::hses::wrong_instance};
    elements = {text("emulated", 24), text(cabinet_.model().type, 16), text("", 8)};
  } else if (request.command == hses::axis_names) {
    if (!is_robot(request.instance)) return {.refusal = arm::hses::wrong_instance};
    const bool in_base = request.instance == arm::hses::robot_base;
    constexpr std::string_view of_joints[] = {"S", "L", "U", "R", "B", "T", "", ""};
    constexpr std::string_view of_base[] = {"X", "Y", "Z", "Rx", "Ry", "Rz", "", ""};
    for (const std::string_view name : in_base ? of_base : of_joints) elements.push_back(text(name, 4));
  } else {
    if (request.instance != arm::hses::robot_pulses) return {.refusal = arm::hses::wrong_instance};
    elements = std::vector<std::string>(axes, words(1));
  }
  return hses_elements(request, elements);
}

// Since when, which it does not know, and how long.
HsesOutcome HsesReports::management_time(const arm::HsesRequest& request) const {
  struct Kind {
    std::uint16_t instance;
    Duration ArmCabinet::WorkTimes::*time;
  };
  using Times = ArmCabinet::WorkTimes;
  constexpr Kind kinds_of_time[] = {{1, &Times::power},    {10, &Times::servo},   {11, &Times::servo},
                                    {110, &Times::motion}, {111, &Times::motion}, {210, &Times::motion},
                                    {211, &Times::motion}, {301, &Times::motion}};
  const auto* kind = std::ranges::find(kinds_of_time, request.instance, &Kind::instance);
  if (kind == std::end(kinds_of_time)) return {.refusal = arm::hses::wrong_instance};
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(cabinet_.work_times().*(kind->time)).count();
  std::string since = "0000/00/00 00:00";
  std::string elapsed = fmt::format("{:06}:{:02}'{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
  return hses_elements(request, {std::move(since), std::move(elapsed)});
}

}  // namespace pizarra::simulation
