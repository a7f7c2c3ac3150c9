// pizarra-bench-fleet: many cells on one machine, each a board of its own with ten agents: what they do together, and
// what memory each board takes.

#include <fmt/format.h>
#include <numeric>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/reader.hpp"
#include "tests/bench/bench_main.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/figures.hpp"
#include "tests/bench/measure.hpp"
#include "tests/run_task.hpp"

namespace pizarra::bench {
namespace {

constexpr int agents_a_cell = 10;
constexpr int facts_an_agent = 20;  // that it tells anew, one after another

struct Choices {
  std::vector<int> cells = {1, 10, 50};
  double seconds = 3;
  bool json = false;
};

Task<void> tell_on(client::RemoteBoard& board, int agent, const bool* over, double* told) {
  for (std::int64_t n = 0; !*over; ++n) {
    const Result<Revision> revision = co_await board.tell(list("state"_sym, agent, n % facts_an_agent, n));
    if (revision) *told += 1;
  }
}

// The agents of one cell, in a process; says how many facts they told.
void be_agents(const std::string& address, double seconds, Pipe& parent) {
  RealExecutor executor;
  std::vector<std::unique_ptr<client::RemoteBoard>> boards;
  const std::vector<Relation> relations = {
      relation_from_datum(
          read_one("(relation state ((agent integer) (what integer) (value integer)) (key agent what))").value())
          .value()};
  for (int agent = 0; agent < agents_a_cell; ++agent) {
    boards.push_back(client::RemoteBoard::connect(executor, address, fmt::format("agent-{}", agent)).value());
    while (!run(executor, boards.back()->declare(relations))) continue;
  }
  parent.say(0);
  parent.hear();
  bool over = false;
  double told = 0;
  std::vector<Job> jobs;
  for (int agent = 0; agent < agents_a_cell; ++agent) {
    jobs.push_back(executor.spawn(tell_on(*boards[static_cast<std::size_t>(agent)], agent, &over, &told)));
  }
  executor.call_at(executor.now() + Duration(static_cast<Duration::rep>(seconds * 1e6)), [&] { over = true; });
  executor.run_until([&] { return std::ranges::all_of(jobs, [](const Job& job) { return job.done(); }); });
  parent.say(told);
}

struct Fleet {
  double facts_per_s = 0;
  double board_mb = 0;  // of one, the median
  int silent = 0;       // cells whose agents told nothing
};

Fleet measure(int cells, double seconds) {
  const TemporaryFolder folder;
  std::vector<Child> boards;
  std::vector<Child> agents;
  for (int cell = 0; cell < cells; ++cell) {
    const std::string address = fmt::format("ipc://{}/{}.ipc", folder.path(), cell);
    boards.push_back(Child::program({program_beside("pizarra-board"), "--listen", address}));
    agents.push_back(Child::running([=](Pipe& parent) { be_agents(address, seconds, parent); }));
  }
  for (Child& cell : agents) cell.pipe().hear();
  for (Child& cell : agents) cell.pipe().say(0);
  Fleet fleet;
  for (Child& cell : agents) {
    const double told = cell.pipe().hear();
    fleet.facts_per_s += told / seconds;
    if (told == 0) ++fleet.silent;
  }
  std::vector<double> memory;
  for (const Child& board : boards) memory.push_back(board.memory_mb("VmRSS"));
  fleet.board_mb = percentile(memory, 0.5);
  return fleet;
}

int run_all(const Choices& choices) {
  Figures figures("fleet", choices.json ? Figures::Style::json : Figures::Style::plain);
  for (const int cells : choices.cells) {
    const Fleet fleet = measure(cells, choices.seconds);
    const std::string what = fmt::format("{} {} of {} agents", cells, cells == 1 ? "cell" : "cells", agents_a_cell);
    figures.say({what + ", all together", fleet.facts_per_s, "facts/s", {}});
    figures.say({what + ", a board's memory", fleet.board_mb, "MB", {}});
    figures.must_be_none(what + ", cells that told nothing", fleet.silent);
  }
  return figures.finish();
}

}  // namespace
}  // namespace pizarra::bench

int main(int argc, char** argv) {
  CLI::App app("Many cells on one machine, each a board with ten agents that tell as fast as they can.",
               "pizarra bench fleet");
  pizarra::bench::Choices choices;
  app.add_option("--cells", choices.cells, "how many, one measurement each")
      ->check(CLI::Range(1, 200))
      ->capture_default_str();
  app.add_option("--seconds", choices.seconds, "how long they tell")
      ->check(CLI::Range(0.1, 600.0))
      ->capture_default_str();
  app.add_flag("--json", choices.json, "one JSON object a line");
  app.footer("Status 0 when every figure was measured, and in every cell facts were told.");
  return pizarra::bench::bench_main(app, argc, argv, [&] { return pizarra::bench::run_all(choices); });
}
