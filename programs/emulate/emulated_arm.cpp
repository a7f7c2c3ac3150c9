#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "drivers/arm/arm_file.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/emulate/arm_serving.hpp"
#include "programs/emulate/body.hpp"
#include "programs/emulate/bystander.hpp"
#include "programs/emulate/devices.hpp"

namespace pizarra::programs {

namespace {

std::string in_json(const simulation::ArmCabinet& cabinet, const arm::ArmReading& reading) {
  return fmt::format(
      "{{\"power\":{},\"servo\":{},\"pendant\":{},\"estop\":{},\"hold\":{},\"alarm\":{},\"override\":{:.0f},"
      "\"state\":\"{}\",\"joints\":[{:.4f}],\"opening\":{:.2f},\"moves\":{}}}",
      cabinet.powered(), cabinet.servo(), cabinet.pendant(), cabinet.emergency(),
      cabinet.pendant_hold() || cabinet.command_hold(), cabinet.alarm(), cabinet.speed_override() * 100,
      reading.moving ? "moving" : "still", fmt::join(reading.joints, ","), reading.opening_mm, cabinet.moves());
}

std::string in_words(const simulation::ArmCabinet& cabinet, const arm::ArmReading& reading) {
  std::string line =
      fmt::format("power {}, servo {}", cabinet.powered() ? "on" : "off", cabinet.servo() ? "on" : "off");
  if (cabinet.pendant()) line += ", the pendant has control";
  if (cabinet.emergency()) line += ", emergency stop";
  if (cabinet.pendant_hold() || cabinet.command_hold()) line += ", held";
  if (cabinet.alarm() != 0) line += fmt::format(", alarm {}", cabinet.alarm());
  if (cabinet.speed_override() < 1) line += fmt::format(", override {:.0f} %", cabinet.speed_override() * 100);
  return fmt::format("{}, {} at {:.2f}, gripper {:.1f} mm, {} moves", line, reading.moving ? "moving" : "still",
                     fmt::join(reading.joints, " "), reading.opening_mm, cabinet.moves());
}

Task<std::string> status(simulation::ArmCabinet& cabinet, bool json) {
  const arm::ArmReading reading = co_await cabinet.read();
  co_return json ? in_json(cabinet, reading) : in_words(cabinet, reading);
}

}  // namespace

std::vector<std::string> arm_device_names() {
  std::vector<std::string> names;
  for (const ArmKind& kind : arm_kinds()) names.emplace_back(kind.name);
  return names;
}

int emulate_arm(const EmulateChoices& choices) {
  const ArmKind& kind = *std::ranges::find(arm_kinds(), choices.device, &ArmKind::name);
  if (choices.pty && !kind.serial) {
    const Failure useless{"bad-option", choices.device + " is on a network, not at a serial line", {}, {}};
    return complain(useless, exit_usage);
  }
  const Result<arm::ArmModel> model = arm::shipped_arm(kind.arm);
  if (!model) return complain(model.error(), exit_usage);
  RealExecutor executor;
  const StopSignals signals(executor);
  Body body(executor, *model, choices.world);
  simulation::ArmCabinet cabinet(executor, body.arm(), *model);
  const int last = choices.port + kind.ports - 1;
  constexpr int highest = 65535;
  if (last > highest) {
    const Failure beyond{
        "bad-option",
        fmt::format("{} has {} ports, and from {} on there are not so many", choices.device, kind.ports, choices.port),
        {},
        {}};
    return complain(beyond, exit_usage);
  }
  const Result<ArmServing> serving = kind.serve(executor, cabinet, choices);
  if (!serving) return complain(serving.error(), exit_unavailable);
  say_where(choices, serving->where);
  const Bystander bystander(executor, {.obey = [&](std::string_view words) { return cabinet.obey(words); },
                                       .status = [&] { return status(cabinet, choices.json); }});
  executor.run_until([] { return false; });
  return exit_reached;
}

}  // namespace pizarra::programs
