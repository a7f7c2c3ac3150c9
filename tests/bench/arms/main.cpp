// pizarra-bench-arms: the arms that come with the tree, their kinematics and how fast they stop.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "tests/bench/arms/rows.hpp"

namespace {

struct Row {
  const char* name;
  void (*measure)(pizarra::bench::ArmsBench&);
};

using namespace pizarra::bench;
constexpr std::array table = {
    Row{"move", one_move},     Row{"targets", random_targets}, Row{"lines", lines_of_description},
    Row{"stop", stop_latency}, Row{"loss", bad_network},       Row{"command", command_latency},
    Row{"state", state_stream}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "Every arm of arms/: inverse kinematics, random targets, lines of description; how fast a stop arrives; how "
      "often an arm tells its state; and moves over a network that loses datagrams.",
      "pizarra bench arms");
  bool json = false;
  std::uint64_t targets = 1'000'000;
  std::uint64_t stops = 1000;
  std::uint64_t moves = 10'000;
  std::vector<std::string> only;
  std::vector<std::string> names;
  for (const Row& row : table) names.emplace_back(row.name);
  app.add_flag("--json", json, "one JSON object a line");
  app.add_option("--only", only, "these rows alone")->check(CLI::IsMember(names))->type_name("ROW");
  app.add_option("--targets", targets, "reachable targets of every arm, and as many others")
      ->check(CLI::Range(1000, 100'000'000))
      ->capture_default_str();
  app.add_option("--stops", stops, "how often an arm in motion is stopped, and one at rest commanded")
      ->check(CLI::Range(10, 1'000'000))
      ->capture_default_str();
  app.add_option("--moves", moves, "over a network that loses a fifth and repeats a tenth")
      ->check(CLI::Range(10, 10'000'000))
      ->capture_default_str();
  app.footer("Status 0 when every figure was measured, short or not; 1 when one was not; 2 for wrong arguments.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  pizarra::bench::Figures figures("arms",
                                  json ? pizarra::bench::Figures::Style::json : pizarra::bench::Figures::Style::plain);
  ArmsBench bench{figures, targets, stops, moves};
  for (const Row& row : table) {
    if (!only.empty() && std::ranges::find(only, row.name) == only.end()) continue;
    try {
      row.measure(bench);
    } catch (const std::exception& error) {
      fmt::print(stderr, "pizarra bench arms: {}: {}\n", row.name, error.what());
      figures.say({row.name, {}, "", {}, {}, error.what()});
    }
  }
  return figures.finish();
}
