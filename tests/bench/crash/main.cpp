// pizarra-bench-crash: kills, stops and cuts off a board, or boards that take over from each other, and their clients.
// It then proves that what is acknowledged is kept, that nothing is done twice, and that no watcher misses a change
// without being told so.

#include <fmt/format.h>

#include "programs/command_line/command_tools.hpp"
#include "tests/bench/bench_main.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/crash/cluster_ordeal.hpp"
#include "tests/bench/crash/lone_ordeal.hpp"
#include "tests/bench/stopping.hpp"

namespace pizarra::bench {
namespace {

bool is_stopped() { return stopped_by() != 0; }

Result<Verdict> live_through(Ordeal& ordeal, int rounds) {
  for (int done = 0; done < rounds; ++done) ordeal.round();
  ordeal.settle();
  Result<Verdict> verdict = ordeal.judge();
  throw_if_stopped();
  return verdict;
}

int say(const Result<Verdict>& verdict, int rounds) {
  if (!verdict) {
    fmt::print(stderr, "pizarra bench crash: {}\n", describe(verdict.error()));
    return 1;
  }
  fmt::print(stderr, "{}", verdict->unexplained);
  fmt::print("rounds {}, acknowledged {}, lost {}, duplicated effects {}, gaps unnoticed {}, not linearizable {}\n",
             rounds, verdict->acknowledged, verdict->lost, verdict->duplicated_effects, verdict->gaps,
             verdict->not_linearizable);
  const bool sound =
      verdict->lost == 0 && verdict->duplicated_effects == 0 && verdict->gaps == 0 && verdict->not_linearizable == 0;
  return sound && verdict->acknowledged > 0 && verdict->operations > 0 ? 0 : 1;
}

int run_alone(int rounds, std::uint64_t seed) {
  const TemporaryFolder folder;
  LoneOrdeal ordeal(folder.path(), seed, is_stopped);
  const Result<Verdict> verdict = live_through(ordeal, rounds);
  fmt::print("seed {}, a board and its clients through {} rounds of kill -9, stops and cut links\n", seed, rounds);
  return say(verdict, rounds);
}

int run_cluster(int rounds, std::uint64_t seed) {
  if (const std::string why = ClusterCell::unavailable(); !why.empty()) {
    fmt::print("skipped: {}\n", why);
    return 0;
  }
  const TemporaryFolder folder;
  ClusterOrdeal ordeal(folder.path(), seed, is_stopped);
  const Result<Verdict> verdict = live_through(ordeal, rounds);
  fmt::print("seed {}, two boards, an etcd cluster and their clients on three hosts: {}\n", seed, ordeal.faults());
  if (verdict) fmt::print("{} operations on registers\n", verdict->operations);
  return say(verdict, rounds);
}

}  // namespace
}  // namespace pizarra::bench

int main(int argc, char** argv) {
  CLI::App app("Kills, stops and cuts off a board and its clients at random, and counts what was lost.",
               "pizarra bench crash");
  int rounds = 200;
  std::uint64_t seed = 1;
  app.add_option("--rounds", rounds, "how many faults, about 0.4 s each, 0.9 s in a cluster")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--seed", seed, "what chance begins from; the machine's timing has its share")
      ->check(pizarra::programs::seed_check())
      ->capture_default_str();
  bool cluster = false;
  app.add_flag("--cluster", cluster,
               "two boards on an etcd cluster of three members, on hosts in network namespaces (as root), which are "
               "cut off from each other, whose clocks jump and one of whose disks gets full, as well");
  app.footer(
      "Status 0 when nothing was lost, done twice or missed unnoticed, and when what registers were asked and "
      "answered\n"
      "could have come of one board that does one thing at a time; 1 otherwise; 2 for wrong arguments; 130 or\n"
      "143 when it was stopped by SIGINT or SIGTERM, which ends it without a verdict.");
  pizarra::bench::stop_in_order();
  return pizarra::bench::bench_main(app, argc, argv, [&] {
    return cluster ? pizarra::bench::run_cluster(rounds, seed) : pizarra::bench::run_alone(rounds, seed);
  });
}
