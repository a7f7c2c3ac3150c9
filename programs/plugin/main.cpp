// Runs one plug-in of a driver: pizarra-plugin arm|camera LIBRARY --listen ADDRESS. `up` starts it beside the agent
// that drives it.

#include <fmt/format.h>
#include <sys/prctl.h>
#include <zmq.hpp>

#include "blackboard/time/real_executor.hpp"
#include "blackboard/time/stop_signals.hpp"
#include "drivers/simulation/link_server.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/plugin/plugin_devices.hpp"
#include "programs/plugin/plugin_library.hpp"

namespace pizarra::programs {
namespace {

struct PluginChoices {
  std::string kind;
  std::string library;
  std::string folder;
  std::string address;
};

Result<std::unique_ptr<PluginDevice>> make_device(const PluginChoices& choices, const PluginLibrary& library,
                                                  Executor& executor) {
  const bool arm = choices.kind == "arm";
  const Result<void*> maker = library.symbol(arm ? "pizarra_make_arm" : "pizarra_make_camera");
  if (!maker) return fail(maker);
  try {
    if (arm) {
      return device_of(std::unique_ptr<plugin::Arm>(reinterpret_cast<plugin::Arm* (*)()>(*maker)()));
    }
    return device_of(std::unique_ptr<plugin::Camera>(reinterpret_cast<plugin::Camera* (*)()>(*maker)()), executor);
  } catch (const std::exception& error) {
    return fail("bad-plugin", fmt::format("{} cannot begin: {}", choices.library, error.what()));
  }
}

int run_plugin(const PluginChoices& choices) {
  RealExecutor executor;
  const StopSignals signals(executor);
  const Result<PluginLibrary> library = PluginLibrary::load(choices.library, plugin_folders(choices.folder));
  if (!library) return complain(library.error(), exit_usage);
  // A program that it might start gets no more rights than it has.
  prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0);
  const Result<std::unique_ptr<PluginDevice>> device = make_device(choices, *library, executor);
  if (!device) return complain(device.error(), exit_usage);
  zmq::context_t context(1);
  const auto handle = [&device](Datum request) -> Task<Result<simulation::Message>> {
    co_return (*device)->handle(request);
  };
  const auto server = simulation::LinkServer::listen(executor, context, choices.address, handle);
  if (!server) return complain(server.error(), exit_unavailable);
  fmt::print("the {} of {} is reached at {}\n", choices.kind, choices.library, choices.address);
  std::fflush(stdout);
  executor.run_until([] { return false; });
  return exit_reached;
}

int main_of(int argc, char** argv) {
  CLI::App app("Runs one plug-in of a driver, in a process of its own.", "pizarra-plugin");
  PluginChoices choices;
  app.add_option("KIND", choices.kind, "arm or camera")->required()->check(CLI::IsMember({"arm", "camera"}));
  app.add_option("LIBRARY", choices.library, "The plug-in's file name, such as libmyarm.so")->required();
  app.add_option("--listen", choices.address, "Where its agent reaches it: ipc://PATH")->required();
  app.add_option("--plugins", choices.folder,
                 "The folder it lies in; else those of PIZARRA_PLUGINS, else `plugins` beside this program");
  app.footer(exit_code_help);
  int status = exit_reached;
  app.callback([&] { status = run_plugin(choices); });
  return run_program(app, argc, argv, status);
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) { return pizarra::programs::main_of(argc, argv); }
