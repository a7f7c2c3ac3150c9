#include <fmt/format.h>

#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "drivers/line/pty_wire.hpp"
#include "drivers/line/tcp_port.hpp"
#include "drivers/simulation/controllers/serve.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/emulate/bystander.hpp"
#include "programs/emulate/devices.hpp"

namespace pizarra::programs {

namespace {

constexpr std::uint16_t own_port = 4000;

struct Line {
  std::unique_ptr<line::ByteWire> wire;
  std::string where;  // what a driver opens
};

Result<Line> make_line(Executor& executor, const EmulateChoices& choices) {
  if (choices.pty) {
    Result<std::unique_ptr<line::PtyWire>> line = line::PtyWire::make(executor);
    if (!line) return fail(line);
    std::string path = (*line)->path();
    return Line{std::move(*line), std::move(path)};
  }
  const std::uint16_t wanted = choices.port < 0 ? own_port : static_cast<std::uint16_t>(choices.port);
  Result<std::unique_ptr<line::TcpPort>> port = line::TcpPort::listen(executor, choices.address, wanted);
  if (!port) return fail(port);
  std::string where = fmt::format("tcp://{}:{}", choices.address, (*port)->port());
  return Line{std::move(*port), std::move(where)};
}

Result<void> obey(simulation::PtuEmulator& unit, std::string_view words) {
  if (words != "power on" && words != "power off") {
    return fail("unknown-command", fmt::format("nobody here understands '{}': power on, power off, status", words));
  }
  unit.power(words == "power on");
  return {};
}

std::string status(simulation::PtuEmulator& unit, bool json) {
  const char* moves = unit.moving() ? "moving" : "still";
  if (json) {
    return fmt::format("{{\"power\":{},\"pan\":{:.4f},\"tilt\":{:.4f},\"state\":\"{}\"}}", unit.powered(),
                       unit.pan_deg(), unit.tilt_deg(), moves);
  }
  return fmt::format("power {}, pan {:.2f} tilt {:.2f} degrees, {}", unit.powered() ? "on" : "off", unit.pan_deg(),
                     unit.tilt_deg(), moves);
}

Task<std::string> say_status(simulation::PtuEmulator& unit, bool json) { co_return status(unit, json); }

}  // namespace

std::vector<std::string> pan_tilt_names() {
  std::vector<std::string> names;
  for (const simulation::PtuModel& model : simulation::ptu_models()) names.emplace_back(model.name);
  return names;
}

int emulate_pan_tilt(const EmulateChoices& choices) {
  if (!choices.world.empty()) {
    const Failure useless{"bad-option", "a pan-tilt unit of `emulate` moves nothing of a simulated world", {}, {}};
    return complain(useless, exit_usage);
  }
  RealExecutor executor;
  const StopSignals signals(executor);
  simulation::PtuEmulator unit(executor, *simulation::find_ptu_model(choices.device));
  const Result<Line> line = make_line(executor, choices);
  if (!line) return complain(line.error(), exit_unavailable);
  const Job serving = executor.spawn(simulation::serve(executor, unit, *line->wire));
  say_where(choices, line->where);
  const Bystander bystander(executor, {.obey = [&](std::string_view words) { return obey(unit, words); },
                                       .status = [&] { return say_status(unit, choices.json); }});
  executor.run_until([] { return false; });
  return exit_reached;
}

}  // namespace pizarra::programs
