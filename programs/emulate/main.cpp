// pizarra-emulate: a device's controller as a program, at the end of a line that drivers open like the real one's.

#include <algorithm>
#include <fmt/format.h>

#include "drivers/simulation/link_address.hpp"
#include "lisp/json.hpp"
#include "lisp/outside_text.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/emulate/devices.hpp"

namespace pizarra::programs {

void say_where(const EmulateChoices& choices, const std::string& where) {
  if (choices.json) {
    fmt::print("{{\"emulates\":{},\"at\":{}}}\n", json_string(choices.device), json_string(where));
  } else {
    fmt::print("{} at {}\n", text_of_bytes(choices.device), text_of_bytes(where));
  }
  std::fflush(stdout);
}

namespace {

constexpr const char* udp_device = "up6";

std::vector<std::string> device_names() {
  std::vector<std::string> names = pan_tilt_names();
  std::ranges::copy(arm_device_names(), std::back_inserter(names));
  names.emplace_back(gripper_name);
  return names;
}

// Where drivers reach the device.
struct Lines {
  CLI::Option* tcp;
  CLI::Option* udp;
};

Lines add_lines(CLI::App* word, EmulateChoices& choices) {
  const auto add_port = [&](const char* name, const char* help) {
    return word->add_option(name, choices.port, help)->check(CLI::Range(0, 65535));
  };
  CLI::Option* pty = word->add_flag(
      "--pty", choices.pty, "Open a pseudo-terminal, like a serial line; f3 has two, motion and state, like a C500C");
  CLI::Option* tcp = add_port(
      "--tcp",
      "Listen at this TCP port, and at those after it where the device has several; 0: any free ones. Default: the "
      "device's own: 4000 of pan-tilt units, 80 of up6-nx100, 50240 and 50241 of up6-motoros, 30004, 30002, "
      "29999, 30001 and 30003 of ur5e, 11000 and 11002 of f3 and f3-track, 502 of gripper");
  CLI::Option* udp = add_port("--udp", "The same for up6, which has two UDP ports: 10040 and 10041");
  tcp->excludes(pty)->excludes(udp);
  udp->excludes(pty);
  word->add_option("--address", choices.address, "The address on which its port listens; default: only this machine")
      ->capture_default_str()
      ->excludes(pty);
  return {tcp, udp};
}

int emulate(const EmulateChoices& choices, const Lines& lines) {
  const bool by_udp = choices.device == udp_device;
  const CLI::Option* other = by_udp ? lines.tcp : lines.udp;
  if (other->count() > 0) {
    const std::string sentence = fmt::format("{} is at a {} port, which {} says", choices.device,
                                             by_udp ? "UDP" : "TCP", by_udp ? "--udp" : "--tcp");
    return complain(Failure{"bad-option", other->get_name() + ": " + sentence, {}, {}}, exit_usage);
  }
  const std::vector<std::string> units = pan_tilt_names();
  const bool unit = std::ranges::find(units, choices.device) != units.end();
  if (choices.device == gripper_name) return emulate_gripper(choices);
  return unit ? emulate_pan_tilt(choices) : emulate_arm(choices);
}

void add_emulate_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<EmulateChoices>();
  CLI::App* emulating = app.add_subcommand(
      "emulate",
      "Run a device's controller without the device, to try drivers on. It speaks the device's own protocol,\n"
      "keeps state, moves in time, and refuses what the device refuses. Until Ctrl-C.");
  emulating
      ->add_option(
          "device", choices->device,
          "The device: a pan-tilt unit, ptu46-17.5 or ptu46-70; an arm, up6 (High Speed Ethernet Server), up6-nx100 "
          "(Ethernet Server, or a serial line), up6-motoros (MotoROS), up6-motoros-fs100 (in the other byte order), "
          "ur5e (RTDE, URScript, dashboard), f3 (ROS-Industrial simple_message) or f3-track (with its track); or "
          "gripper (Modbus TCP)")
      ->required()
      ->check(CLI::IsMember(device_names()));
  const Lines lines = add_lines(emulating, *choices);
  emulating
      ->add_option("--world", choices->world,
                   "Move the arm of the simulated world at this address, ipc://PATH, as `world` and `up` "
                   "have one")
      ->check([](const std::string& text) {
        return simulation::is_link_address(text) ? std::string() : "a simulated world is at ipc://PATH";
      });
  emulating
      ->add_option("--programs", choices->programs,
                   "The folder of a ur5e's stored programs, files of URScript that the dashboard loads and plays")
      ->check(CLI::ExistingDirectory);
  emulating->add_flag("--json", choices->json, "Print one JSON object a line");
  emulating->footer(help_footer(
      "emulate ptu46-17.5 --tcp 4000",
      "You stand beside the device and type, one line each: `power off`, `power on`, `status`; for\n"
      "an arm also `estop`, `pendant`, `hold` and `servo` with `on` or `off`, `alarm CODE`, `override PERCENT`;\n"
      "for a gripper also `fault CODE` and `refuse CODE`.\n"
      "Exit status: 0 interrupted; 2 a wrong word or option; 4 no terminal or port is free."));
  emulating->callback([choices, lines, &status] { status = emulate(*choices, lines); });
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_emulate_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
