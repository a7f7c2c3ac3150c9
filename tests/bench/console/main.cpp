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

// Of the cell that is in `folder`; its addresses go there, too.
std::vector<std::string> console_command(const std::string& folder, int port) {
  return {PIZARRA_CELL,         "console",     folder + "/cell.scm", "--port",
          std::to_string(port), "--addresses", folder + "/addresses"};
}

std::vector<std::string> measure_command(const Choices& choices, const std::string& folder) {
  return {"node", script("measure.mjs"), folder, std::to_string(choices.jog_seconds)};
}

// The cell that is measured, in `folder`.
Measured write_cell(const std::string& folder) { return measure({"node", script("pictures.mjs"), folder}); }

Measured in_a_crowd() {
  const TemporaryFolder scratch;
  return measure({"node", script("crowd.mjs"), PIZARRA_CELL, scratch.path()});
}

Measured over_loopback(const Choices& choices) {
  const TemporaryFolder folder;
  setenv("XDG_RUNTIME_DIR", folder.path().c_str(), 1);
  if (Measured written = write_cell(folder.path()); !written.trouble.empty()) return written;
  const Child console = Child::program(console_command(folder.path(), 0));
  return measure(measure_command(choices, folder.path()));
}

// The console's loopback, brought to another machine: each connection of the browser is one over the line.
Measured over_the_line(const Choices& choices) {
  if (const std::string why = network::Network::unavailable(); !why.empty()) return {.values = {}, .trouble = why};
  const TemporaryFolder folder;
  constexpr int port = 7801;
  constexpr const char* relayed_port = "7802";
  network::Network network("console", {"cell", "desk"}, network::Network::Wires::forwarded);
  const std::string cell = network.address("cell");
  const std::string own_port = std::to_string(port);
  if (Measured written = write_cell(folder.path()); !written.trouble.empty()) return written;
  const Child console = Child::program(network.on("cell", console_command(folder.path(), port)));
  Child far =
      Child::program(network.on("cell", {"node", script("relay.mjs"), cell, relayed_port, "127.0.0.1", own_port}));
  Child near =
      Child::program(network.on("desk", {"node", script("relay.mjs"), "127.0.0.1", own_port, cell, relayed_port}));
  far.pipe().hear_line();
  near.pipe().hear_line();
  const std::string long_line = "both delay 80 loss 1 rate 2000";
  network.link("desk", long_line);
  std::vector<std::string> command = measure_command(choices, folder.path());
  command.push_back("--cut");
  return measure(network.on("desk", command), [&](const std::string& order) {
    network.link("desk", order == "cut" ? std::string("both cut") : long_line);
  });
}

// A figure, and the scale it is told in.
void say_row(Figures& figures, const std::string& name, std::optional<double> value, const std::string& unit,
             const Goal& goal, double scale = 1, const std::string& note = "") {
  if (value) *value *= scale;
  figures.say({name, value, unit, goal, {}, note});
}

void say_crowd(Figures& figures, const Measured& measured) {
  say_row(figures, "page alive", measured.value("alive"), "ms", at_most(2000));
  for (const std::string whom : {"arm", "board"}) {
    const std::string row = "p99 of a question to the " + whom + ", ten pages, three stalled";
    const double alone_ms = measured.value(whom + "-alone-p99").value_or(0);
    say_row(figures, row, measured.value(whom + "-near-ratio"), "x alone", at_most(1.2), 1,
            fmt::format("alone {:.1f} ms", alone_ms));
    say_row(figures, row + ", the browser giving way", measured.value(whom + "-remote-ratio"), "x alone", at_most(1.2),
            1, "what the console itself costs them");
  }
}

// The rows and goals for an operator over a line that takes `line_ms` one way.
void say_rows(Figures& figures, const std::string& where, const Measured& measured, double line_ms) {
  const auto say = [&](const std::string& name, const std::string& key, const std::string& unit, const Goal& goal,
                       double scale = 1, const std::string& note = "") {
    say_row(figures, where + ": " + name, measured.value(key), unit, goal, scale, note);
  };
  const bool near = line_ms == 0;
  say("image interval, mean", "interval-mean", "s", at_most(near ? 0.105 : 0.2), 1e-3);
  say("image interval, p99", "interval-p99", "s", near ? Goal{} : at_most(0.8), 1e-3);
  say("frame to photon, p99, 3D hidden", "photon-hidden-p99", "ms", at_most(60 + line_ms), 1,
      "from the frame's stamp to the animation frame that reads its number in its pixels");
  say("frame to photon, p99, 3D shown", "photon-shown-p99", "ms", at_most(120 + line_ms));
  say("click to motion, p99", "click-to-motion-p99", "ms", at_most(60 + line_ms));
  const double jogged_s = measured.value("jogged-s").value_or(ten_minutes_s);
  say("false stops of a held jog in ten minutes", "false-stops", "", at_most(1), ten_minutes_s / jogged_s,
      fmt::format("held for {:.0f} s{}", jogged_s, jogged_s < ten_minutes_s ? ": --jog 600 decides" : ""));
  say("way from the last hold to standing, most", "stop-distance-max", "mm", at_most(10));
  say("standing after the deadline, most", "stop-after-deadline-max", "ms", at_most(50));
}

void say_trouble(const std::string& part, const Measured& measured) {
  if (!measured.trouble.empty()) fmt::print(stderr, "pizarra bench console: {}: {}\n", part, measured.trouble);
}

int run(const Choices& choices) {
  Figures figures("console", choices.json ? Figures::Style::json : Figures::Style::plain);
  const auto wanted = [&](const std::string& part) {
    return choices.only.empty() || std::ranges::find(choices.only, part) != choices.only.end();
  };
  if (wanted("crowd")) {
    const Measured measured = in_a_crowd();
    say_trouble("crowd", measured);
    say_crowd(figures, measured);
  }
  for (const std::string& part : {std::string("loopback"), std::string("line")}) {
    if (!wanted(part)) continue;
    const bool near = part == "loopback";
    const Measured measured = near ? over_loopback(choices) : over_the_line(choices);
    say_trouble(part, measured);
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
  app.add_option("--only", choices.only, "crowd, loopback or line; all otherwise")
      ->check(CLI::IsMember({"crowd", "loopback", "line"}));
  app.add_option("--jog", choices.jog_seconds, "how many seconds a jog is held, to count false stops")
      ->check(CLI::Range(1, 3600))
      ->capture_default_str();
  app.add_flag("--json", choices.json, "one JSON object a line");
  app.footer(
      "Needs chromium and node; the long line needs root (network namespaces). Status 0 when every figure was\n"
      "measured, short or not.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : pizarra::programs::exit_usage;
  }
  return pizarra::bench::run(choices);
}
