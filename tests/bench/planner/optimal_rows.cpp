#include <algorithm>
#include <filesystem>
#include <fmt/format.h>

#include "tests/bench/planner/problems.hpp"
#include "tests/bench/planner/rows.hpp"

namespace pizarra::bench {

namespace {

// Peers are asked only where they are so slow that the start of a process does not count.
constexpr double comparable_s = 0.1;

Goal goal_of(const std::vector<Peer>& peers, std::optional<double> bound_s) {
  if (bound_s) return at_most(*bound_s);
  const std::optional<double> best = fastest(peers);
  if (!best) return not_comparable("no optimal peer");
  if (*best < comparable_s) return not_comparable("the peer takes under 0.1 s");
  return at_most(*best / 3, "<= a third of the best optimal peer");
}

void say_optimal(PlannerBench& bench, const std::string& name, const planner::PlanningTask& task,
                 std::optional<double> bound_s = {}) {
  const std::optional<MeasuredPlan> plan = bench.measure(task, Mode::optimal, bench.limit_s);
  const std::vector<Peer> peers = seconds_of(bench.peers, task, bench.limit_s);
  bench.figures.say({name + ", fewest steps", plan ? plan->seconds : bench.limit_s, "s", goal_of(peers, bound_s), peers,
                     plan ? note_of(*plan) : "no plan within the limit"});
}

void all_blocks(PlannerBench& bench) {
  double total_s = 0;
  int problems = 0, missing = 0;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(bench.pddl + "/blocks")) {
    if (entry.path().stem() != "domain") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  for (const std::filesystem::path& file : files) {
    const auto plan = bench.measure(bench.file("blocks", file.stem().string()), Mode::optimal, bench.limit_s);
    total_s += plan ? plan->seconds : bench.limit_s;
    ++problems;
    if (!plan) ++missing;
  }
  bench.figures.say({"all IPC-2000 blocks, fewest steps",
                     total_s,
                     "s",
                     at_most(5),
                     {},
                     fmt::format("{} problems, {} without a plan within the limit", problems, missing)});
}

}  // namespace

void smallest(PlannerBench& bench) {
  say_optimal(bench, "blocks 4", blocks_problem(4, 1), 1.0);
  const auto plan = bench.measure(blocks_problem(10, 1), Mode::fast_first, 5);
  bench.figures.say({"blocks 10, first plan",
                     plan ? plan->seconds * 1000 : 5000,
                     "ms",
                     at_most(1),
                     {},
                     plan ? note_of(*plan) : "no plan within the limit"});
}

void optimal_own(PlannerBench& bench) {
  for (const std::size_t blocks : {4, 6, 8, 10, 12}) {
    say_optimal(bench, fmt::format("blocks {}", blocks), blocks_problem(blocks, 1));
  }
  say_optimal(bench, "hanoi 5", hanoi_problem(5), 1.0);
  say_optimal(bench, "gripper 4", gripper_problem(10), 1.4);
  say_optimal(bench, "logistics, 4 cities, 10 parcels", logistics_problem(4, 10, 1));
  if (bench.quick) return;
  say_optimal(bench, "hanoi 6", hanoi_problem(6), 60.0);
  say_optimal(bench, "gripper 5", gripper_problem(12), bench.limit_s);
  say_optimal(bench, "blocks 20", blocks_problem(20, 1), 30.0);
}

void optimal_pddl(PlannerBench& bench) {
  if (bench.pddl.empty()) {
    bench.figures.say({"IPC problems, fewest steps", 0, "", not_comparable("needs --pddl DIR"), {}, "not measured"});
    return;
  }
  all_blocks(bench);
  for (const char* name : {"10-0", "11-0", "12-0", "14-0", "17-0"}) {
    say_optimal(bench, fmt::format("IPC blocks {}", name), bench.file("blocks", fmt::format("probBLOCKS-{}", name)));
  }
  say_optimal(bench, "IPC logistics 10-0", bench.file("logistics00", "probLOGISTICS-10-0"));
  say_optimal(bench, "IPC logistics 15-0", bench.file("logistics00", "probLOGISTICS-15-0"), 0.2);
  if (!bench.quick) say_optimal(bench, "random blocks 20", bench.file("random-blocks", "bw-20-1"), 10.0);
}

}  // namespace pizarra::bench
