#include <fmt/format.h>

#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "drivers/arm/arm_file.hpp"
#include "drivers/simulation/controllers/gripper/modbus_server.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/emulate/body.hpp"
#include "programs/emulate/bystander.hpp"
#include "programs/emulate/devices.hpp"

namespace pizarra::programs {

namespace {

Task<std::string> status(const simulation::GripperEmulator& gripper, bool json) {
  co_return json ? gripper.status_in_json() : gripper.status();
}

}  // namespace

int emulate_gripper(const EmulateChoices& choices) {
  if (choices.pty) {
    const Failure useless{"bad-option", "the gripper is on a network, not at a serial line", {}, {}};
    return complain(useless, exit_usage);
  }
  const forms::GripperSetup setup;
  const std::uint16_t wanted = static_cast<std::uint16_t>(choices.port < 0 ? setup.port : choices.port);
  RealExecutor executor;
  const StopSignals signals(executor);
  // Any arm will do: it has fingers.
  Body body(executor, arm::crs_f3(), choices.world);
  simulation::GripperEmulator gripper(executor, body.arm(), setup);
  const Result<std::unique_ptr<simulation::ModbusServer>> server =
      simulation::ModbusServer::listen(executor, gripper, choices.address, wanted);
  if (!server) return complain(server.error(), exit_unavailable);
  say_where(choices, fmt::format("tcp://{}:{}", choices.address, (*server)->port()));
  const Bystander bystander(executor, {.obey = [&](std::string_view words) { return gripper.obey(words); },
                                       .status = [&] { return status(gripper, choices.json); }});
  executor.run_until([] { return false; });
  return exit_reached;
}

}  // namespace pizarra::programs
