// pizarra-bench-console: times and rates of the console as an operator has them in a real browser. It measures over
// loopback, and over a long, slow and lossy line (80 ms each way, 2 Mbit/s, 1 % of the packets lost) between two
// network namespaces.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

#include "programs/command_line/command_tools.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/console/measured.hpp"
#include "tests/bench/figures.hpp"
#include "tests/network/network.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {
namespace {

constexpr double ten_minutes_s = 600;

struct Choices {
  std::vector<std::string> only;
  int jog_seconds = 60;
  bool json = false;
};

std::string script(const std::string& name) { return source_dir() + "/tests/bench/console/" + name; }

std::vector<std::string> console_command(const std::string& addresses, int port) {
  return {PIZARRA_CELL, "console", "--port", std::to_string(port), "--addresses", addresses};
}

std::vector<std::string> measure_command(const Choices& choices, const std::string& folder,
                                         const std::string& addresses) {
  return {"node", script("measure.mjs"), folder, addresses, std::to_string(choices.jog_seconds)};
}

Measured over_loopback(const Choices& choices) {
  const TemporaryFolder folder;
  setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1);
  const std::string addresses = folder.path() + "/addresses";
  const Child console = Child::program(console_command(addresses, 0));
  std::vector<std::string> command = measure_command(choices, folder.path(), addresses);
  command.push_back("--crowd");
  return measure(command);
}

// As `ssh -L` brings a console to another machine: its own loopback there, and one connection over the line.
Measured over_the_line(const Choices& choices) {
  if (const std::string why = network::Network::unavailable(); !why.empty()) return {.values = {}, .trouble = why};
  const TemporaryFolder folder;
  const std::string addresses = folder.path() + "/addresses";
  constexpr int port = 7801;
  constexpr const char* relayed_port = "7802";
  network::Network network("console", {"cell", "desk"}, network::Network::Wires::forwarded);
  const std::string cell = network.address("cell");
  const std::string own_port = std::to_string(port);
  const Child console = Child::program(network.on("cell", console_command(addresses, port)));
  Child far =
      Child::program(network.on("cell", {"node", script("relay.mjs"), cell, relayed_port, "127.0.0.1", own_port}));
  Child near =
      Child::program(network.on("desk", {"node", script("relay.mjs"), "127.0.0.1", own_port, cell, relayed_port}));
  far.pipe().hear_line();
  near.pipe().hear_line();
  network.link("desk", "both delay 80 loss 1 rate 2000");
  return measure(network.on("desk", measure_command(choices, folder.path(), addresses)));
}

// The rows and goals for an operator over a line that takes `line_ms` one way.
void say_rows(Figures& figures, const std::string& where, const Measured& measured, double line_ms) {
  const auto say = [&](const std::string& name, const std::string& key, const std::string& unit, const Goal& goal,
                       double scale = 1, const std::string& note = "") {
    std::optional<double> value = measured.value(key);
    if (value) *value *= scale;
    figures.say({where + ": " + name, value, unit, goal, {}, note});
  };
  const bool near = line_ms == 0;
  say("page alive", "alive", "ms", near ? at_most(2000) : Goal{});
  say("image interval, mean", "interval-mean", "s", at_most(near ? 0.105 : 0.2), 1e-3);
  say("image interval, p99", "interval-p99", "s", near ? Goal{} : at_most(0.8), 1e-3);
  say("frame to photon, p99, 3D hidden", "photon-hidden-p99", "ms", at_most(60 + line_ms), 1,
      "from the camera to the animation frame that draws it");
  say("frame to photon, p99, 3D shown", "photon-shown-p99", "ms", at_most(120 + line_ms));
  say("click to motion, p99", "click-to-motion-p99", "ms", at_most(60 + line_ms));
  const double jogged_s = measured.value("jogged-s").value_or(ten_minutes_s);
  say("false stops of a held jog in ten minutes", "false-stops", "", at_most(1), ten_minutes_s / jogged_s,
      fmt::format("held for {:.0f} s", jogged_s));
  say("way from the last hold to standing, most", "stop-distance-max", "mm", at_most(10));
  say("standing after the deadline, most", "stop-after-deadline-max", "ms", at_most(50));
  if (!near) return;
  for (const std::string whom : {"arm", "board"}) {
    const double alone_ms = measured.value(whom + "-alone-p99").value_or(0);
    say("p99 of a question to the " + whom + ", ten pages, three stalled", whom + "-crowd-ratio", "x alone",
        at_most(1.2), 1, fmt::format("alone {:.1f} ms", alone_ms));
  }
}

int run(const Choices& choices) {
  Figures figures("console", choices.json ? Figures::Style::json : Figures::Style::plain);
  const auto wanted = [&](const std::string& part) {
    return choices.only.empty() || std::ranges::find(choices.only, part) != choices.only.end();
  };
  for (const std::string& part : {std::string("loopback"), std::string("line")}) {
    if (!wanted(part)) continue;
    const bool near = part == "loopback";
    const Measured measured = near ? over_loopback(choices) : over_the_line(choices);
    if (!measured.trouble.empty()) fmt::print(stderr, "pizarra bench console: {}: {}\n", part, measured.trouble);
    constexpr double one_way_ms = 80;
    say_rows(figures, near ? "loopback" : "long line", measured, near ? 0 : one_way_ms);
  }
  return figures.finish();
}

}  // namespace
}  // namespace pizarra::bench

int main(int argc, char** argv) {
  CLI::App app("What an operator has of the console in chromium, over loopback and over a long line.",
               "pizarra bench console");
  pizarra::bench::Choices choices;
  app.add_option("--only", choices.only, "loopback or line; both otherwise")
      ->check(CLI::IsMember({"loopback", "line"}));
  app.add_option("--jog", choices.jog_seconds, "how many seconds a jog is held, to count false stops")
      ->check(CLI::Range(1, 3600))
      ->capture_default_str();
  app.add_flag("--json", choices.json, "one JSON object a line");
  app.footer(
      "Needs chromium, node and npm; the long line needs root (network namespaces). Status 0 when every figure was\n"
      "measured, short or not.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : pizarra::programs::exit_usage;
  }
  return pizarra::bench::run(choices);
}
