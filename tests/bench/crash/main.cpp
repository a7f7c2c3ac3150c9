// pizarra-bench-crash: what is acknowledged is kept, nothing is done twice, and no watcher misses a change without
// being told so, however a board and its clients are killed, stopped and cut off.

#include <CLI/CLI.hpp>
#include <csignal>
#include <fmt/format.h>

#include "agents/launcher/command_line/word_tools.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/crash/ordeal.hpp"

namespace pizarra::bench {
namespace {

volatile std::sig_atomic_t interrupted = 0;

int run(int rounds, std::uint64_t seed) {
  const TemporaryFolder folder;
  Ordeal ordeal(folder.path(), seed);
  int done = 0;
  for (; done < rounds && interrupted == 0; ++done) ordeal.round();
  ordeal.settle();
  const Result<Verdict> verdict = ordeal.judge();
  if (!verdict) {
    fmt::print(stderr, "pizarra bench crash: {}\n", describe(verdict.error()));
    return 1;
  }
  fmt::print("seed {}, writers, takers and watchers through {} rounds of kill -9, stops and cut links\n", seed, done);
  fmt::print("rounds {}, acknowledged {}, lost {}, duplicated effects {}, gaps unnoticed {}\n", done,
             verdict->acknowledged, verdict->lost, verdict->duplicated_effects, verdict->gaps);
  const bool sound = verdict->lost == 0 && verdict->duplicated_effects == 0 && verdict->gaps == 0;
  return sound && verdict->acknowledged > 0 ? 0 : 1;
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
      ->check(pizarra::seed_check())
      ->capture_default_str();
  app.footer("Status 0 when nothing was lost, done twice or missed unnoticed; 1 otherwise; 2 for wrong arguments.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::signal(SIGINT, [](int) { pizarra::bench::interrupted = 1; });
  std::signal(SIGTERM, [](int) { pizarra::bench::interrupted = 1; });
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return pizarra::bench::run(rounds, seed);
  } catch (const std::exception& error) {
    fmt::print(stderr, "pizarra bench crash: {}\n", error.what());
    return 1;
  }
}
