// pizarra-bench-planner: the planner's modes against their goals and the planners that are installed.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <stdexcept>

#include "agents/planner/files/task_files.hpp"
#include "tests/bench/planner/rows.hpp"

namespace pizarra::bench {

std::optional<MeasuredPlan> PlannerBench::measure(const planner::PlanningTask& task, Mode mode, double limit) {
  std::optional<MeasuredPlan> plan = measured(task, mode, limit);
  if (plan) most_memory_mb = std::max(most_memory_mb, plan->memory_mb);
  return plan;
}

planner::PlanningTask PlannerBench::file(const std::string& domain, const std::string& name) const {
  const std::string folder = pddl + "/" + domain;
  Result<planner::PlanningTask> task = planner::read_task_files(folder + "/domain.pddl", folder + "/" + name + ".pddl");
  if (!task) throw std::runtime_error(task.error().sentence);
  return *task;
}

namespace {

struct Row {
  const char* name;
  void (*measure)(PlannerBench&);
  bool by_default = true;
};
constexpr std::array table = {Row{"smallest", smallest, false}, Row{"cell", cell},
                              Row{"optimal", optimal_own},      Row{"pddl", optimal_pddl},
                              Row{"first", fast_first},         Row{"after", fast_after_a_while},
                              Row{"others", fast_others}};

void measure_rows(PlannerBench& bench, const std::vector<std::string>& only) {
  for (const Row& row : table) {
    const bool chosen = only.empty() ? row.by_default : std::ranges::find(only, row.name) != only.end();
    if (!chosen) continue;
    try {
      row.measure(bench);
    } catch (const std::exception& error) {
      fmt::print(stderr, "pizarra bench planner: {}: {}\n", row.name, error.what());
      bench.figures.say({row.name, {}, "", {}, {}, error.what()});
    }
  }
  if (bench.most_memory_mb > 0) {
    bench.figures.say({"most memory of any row", bench.most_memory_mb, "MB", at_most(200)});
  }
}

}  // namespace

}  // namespace pizarra::bench

int main(int argc, char** argv) {
  using namespace pizarra;
  CLI::App app("The planner's optimal and fast modes, against their goals and the planners that are installed.",
               "pizarra bench planner");
  bool json = false, quick = false;
  double limit_s = 60;
  std::string pddl;
  std::vector<std::string> only, names, peers;
  for (const bench::Row& row : bench::table) names.emplace_back(row.name);
  app.add_flag("--json", json, "one JSON object a line");
  app.add_flag("--quick", quick, "without the rows that take long: about a minute");
  app.add_option("--only", only, "these rows alone")->check(CLI::IsMember(names))->type_name("ROW");
  app.add_option("--pddl", pddl, "benchmarks: blocks/, logistics00/, random-blocks/, each with domain.pddl")
      ->check(CLI::ExistingDirectory)
      ->type_name("DIR");
  app.add_option("--time", limit_s, "the most a plan may take")->check(CLI::PositiveNumber)->type_name("S");
  app.add_option("--peer", peers, "a planner: NAME=COMMAND with {domain}, {problem} and {plan}")
      ->check([](const std::string& text) { return text.find('=') == std::string::npos ? "NAME=COMMAND" : ""; })
      ->type_name("NAME=COMMAND");
  app.footer(
      "M, fast-downward and ff are found on PATH. Every plan is made in a process of its own and validated.\n"
      "Status 0 when every figure was measured, short or not; 1 when one was not; 2 for wrong arguments.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  bench::Figures figures("planner", json ? bench::Figures::Style::json : bench::Figures::Style::plain);
  bench::PlannerBench bench{figures, bench::installed_peers(peers), pddl, limit_s, quick};
  bench::measure_rows(bench, only);
  return figures.finish();
}
