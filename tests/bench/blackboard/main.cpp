// pizarra-bench-blackboard: the board against its goals, raw ZeroMQ and the peers that are installed.

#include <CLI/CLI.hpp>
#include <array>
#include <fmt/format.h>

#include "tests/bench/blackboard/rows.hpp"

namespace {

struct Row {
  const char* name;
  void (*measure)(pizarra::bench::Figures&);
};

using namespace pizarra::bench;
constexpr std::array table = {
    Row{"ask", ask_replica},         Row{"process", in_process},      Row{"start", start_and_memory},
    Row{"scheme", scheme_reaction},  Row{"tell", tell_round_trip},    Row{"tracing", tracing},
    Row{"watcher", tell_to_watcher}, Row{"throughput", throughput},   Row{"durable", durable_tells},
    Row{"recovery", recovery},       Row{"stalled", stalled_watcher}, Row{"streams", streams},
    Row{"door", text_door},          Row{"python", python_client}};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app(
      "The board's speed, against its goals, raw ZeroMQ, and Redis, NATS, MQTT (mosquitto) and CORBA's events "
      "(omniEvents), where they are installed.",
      "pizarra bench blackboard");
  bool json = false;
  std::vector<std::string> only;
  std::vector<std::string> names;
  for (const Row& row : table) names.emplace_back(row.name);
  app.add_flag("--json", json, "one JSON object a line");
  app.add_option("--only", only, "these rows alone")->check(CLI::IsMember(names))->type_name("ROW");
  app.footer("Status 0 when every figure was measured, short or not; 1 when one was not; 2 for wrong arguments.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  pizarra::bench::Figures figures("blackboard",
                                  json ? pizarra::bench::Figures::Style::json : pizarra::bench::Figures::Style::plain);
  for (const Row& row : table) {
    if (!only.empty() && std::ranges::find(only, row.name) == only.end()) continue;
    try {
      row.measure(figures);
    } catch (const std::exception& error) {
      fmt::print(stderr, "pizarra bench blackboard: {}: {}\n", row.name, error.what());
      figures.say({row.name, {}, "", {}, {}, error.what()});
    }
  }
  return figures.finish();
}
