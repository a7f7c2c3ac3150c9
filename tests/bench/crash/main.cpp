// pizarra-bench-crash: what is acknowledged is kept, nothing is done twice, and no watcher misses a change without
// being told so, however a board and its clients are killed, stopped and cut off.

#include <CLI/CLI.hpp>
#include <csignal>
#include <fmt/format.h>

#include "programs/command_line/command_tools.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/crash/ordeal.hpp"

namespace pizarra::bench {
namespace {

volatile std::sig_atomic_t stopped_by = 0;

int run(int rounds, std::uint64_t seed) {
  const TemporaryFolder folder;
  Ordeal ordeal(folder.path(), seed, [] { return stopped_by != 0; });
  for (int done = 0; done < rounds; ++done) ordeal.round();
  ordeal.settle();
  const Result<Verdict> verdict = ordeal.judge();
  if (stopped_by != 0) throw Stopped();
  if (!verdict) {
    fmt::print(stderr, "pizarra bench crash: {}\n", describe(verdict.error()));
    return 1;
  }
  fmt::print("seed {}, writers, takers and watchers through {} rounds of kill -9, stops and cut links\n", seed, rounds);
  fmt::print("rounds {}, acknowledged {}, lost {}, duplicated effects {}, gaps unnoticed {}\n", rounds,
             verdict->acknowledged, verdict->lost, verdict->duplicated_effects, verdict->gaps);
  const bool sound = verdict->lost == 0 && verdict->duplicated_effects == 0 && verdict->gaps == 0;
  return sound && verdict->acknowledged > 0 ? 0 : 1;
}

// Whoever stops the bench may have stopped its processes as well: what was not acknowledged then says nothing.
int say_stopped() {
  fmt::print(stderr, "pizarra bench crash: stopped by a signal, without a verdict\n");
  constexpr int of_signals = 128;
  return of_signals + stopped_by;
}

}  // namespace
}  // namespace pizarra::bench

int main(int argc, char** argv) {
  CLI::App app("Kills, stops and cuts off a board and its clients at random, and counts what was lost.",
               "pizarra bench crash");
  int rounds = 200;
  std::uint64_t seed = 1;
  app.add_option("--rounds", rounds, "how many faults, about 0.4 s each")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--seed", seed, "what chance begins from; the machine's timing has its share")
      ->check(pizarra::programs::seed_check())
      ->capture_default_str();
  app.footer(
      "Status 0 when nothing was lost, done twice or missed unnoticed; 1 otherwise; 2 for wrong arguments; 130 or\n"
      "143 when it was stopped by SIGINT or SIGTERM, which ends it without a verdict.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  for (const int stopping : {SIGINT, SIGTERM}) {
    std::signal(stopping, [](int signal) { pizarra::bench::stopped_by = signal; });
  }
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return pizarra::bench::run(rounds, seed);
  } catch (const std::exception& error) {
    if (pizarra::bench::stopped_by != 0) return pizarra::bench::say_stopped();
    fmt::print(stderr, "pizarra bench crash: {}\n", error.what());
    return 1;
  }
}
