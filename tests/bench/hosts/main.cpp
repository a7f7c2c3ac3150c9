// pizarra-bench-hosts: a whole cell on three hosts, whose boards take over from each other, while the host of the board
// that leads loses its power in the middle of a goal.

#include <fmt/format.h>

#include "lisp/installed_program.hpp"
#include "programs/command_line/command_tools.hpp"
#include "tests/bench/bench_main.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/hosts/host_loss.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/stopping.hpp"

namespace pizarra::bench {
namespace {

bool is_stopped() { return stopped_by() != 0; }

std::string why_unavailable() {
  return installed_program("etcd") ? network::Network::unavailable() : "etcd is not installed: etcd-server";
}

std::string median_and_worst(const std::vector<double>& waits_s) {
  if (waits_s.empty()) return "never";
  return fmt::format("{:.2f} s p50, {:.2f} s worst", percentile(waits_s, 0.5), percentile(waits_s, 1));
}

int run_all(int rounds, std::uint64_t seed) {
  if (const std::string why = why_unavailable(); !why.empty()) {
    fmt::print("skipped: {}\n", why);
    return 0;
  }
  HostLoss cell(seed, is_stopped);
  for (int round = 1; round <= rounds; ++round) {
    cell.round();
    fmt::print("round {}, lost {}\n", round, cell.last());
    std::fflush(stdout);
  }
  fmt::print("from the loss of a host: first tell {}; first news of an operation {}\n",
             median_and_worst(cell.waits().told_s), median_and_worst(cell.waits().worked_s));
  const HostLoss::Tally& tally = cell.tally();
  fmt::print("rounds {}, reached {}, refused correctly {}, failed {}, durable lost {}, done twice {}\n", tally.rounds,
             tally.reached, tally.refused_correctly, tally.failed, tally.durable_lost, tally.done_twice);
  return tally.is_well() ? 0 : 1;
}

}  // namespace
}  // namespace pizarra::bench

int main(int argc, char** argv) {
  CLI::App app(
      "A cell on three hosts, one of which loses its power while a goal is pursued: that of the leading board.",
      "pizarra bench hosts");
  int rounds = 20;
  std::uint64_t seed = 1;
  app.add_option("--rounds", rounds, "goals, some 20 s each")->check(CLI::Range(1, 10'000))->capture_default_str();
  app.add_option("--seed", seed, "what chance begins from; the machine's timing has its share")
      ->check(pizarra::programs::seed_check())
      ->capture_default_str();
  app.footer(
      "As root; elsewhere it says why it is skipped. Status 0 when every goal was reached, as the world shows, or\n"
      "refused because in the world a cube of it is gone, no acknowledged durable fact was lost, and no operation was\n"
      "done twice; 1 otherwise; 2 for wrong arguments; 130 or 143 when it was stopped by SIGINT or SIGTERM.");
  // So that the hosts are taken down.
  pizarra::bench::stop_in_order();
  return pizarra::bench::bench_main(app, argc, argv, [&] { return pizarra::bench::run_all(rounds, seed); });
}
