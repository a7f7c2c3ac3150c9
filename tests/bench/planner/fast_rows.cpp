#include <fmt/format.h>

#include "tests/bench/planner/blocks_greedy.hpp"
#include "tests/bench/planner/problems.hpp"
#include "tests/bench/planner/rows.hpp"

namespace pizarra::bench {

namespace {

struct FirstPlan {
  std::size_t blocks;
  double goal_ms;
};
constexpr FirstPlan first_plans[] = {{10, 1}, {20, 5}, {50, 50}, {100, 250}, {200, 1000}};

// The measured time of a greedy search that looks ahead, on the random blocks of --pddl.
std::optional<double> known_greedy(std::size_t blocks) {
  if (blocks == 50) return 160;
  if (blocks == 100) return 324;
  if (blocks == 200) return 658;
  return std::nullopt;
}

void say_after_a_while(PlannerBench& bench, const std::string& name, std::size_t blocks,
                       const planner::PlanningTask& task, std::optional<double> better_greedy = {}) {
  const double time_s = blocks == 200 ? 10 : 1;
  const auto plan = bench.measure(task, Mode::fast, time_s);
  const std::size_t greedy = blocks_greedy_actions(task);
  Goal goal = at_most(static_cast<double>(greedy), fmt::format("<= {}, near-sighted greedy", greedy));
  if (better_greedy) goal = at_most(*better_greedy, fmt::format("<= {}, far-sighted greedy", *better_greedy));
  if (blocks == 20) {
    const auto optimum = bench.measure(task, Mode::optimal, bench.limit_s);
    goal = optimum ? at_most(1.05 * static_cast<double>(optimum->actions),
                             fmt::format("<= 1.05 x {}, the optimum", optimum->actions))
                   : not_comparable("no optimum within the limit");
  }
  bench.figures.say({fmt::format("{}, after {} s", name, time_s),
                     plan ? std::optional(static_cast<double>(plan->actions)) : std::nullopt,
                     "actions",
                     goal,
                     {{"near-sighted greedy", static_cast<double>(greedy)}},
                     plan ? note_of(*plan) : "no plan"});
}

}  // namespace

void fast_first(PlannerBench& bench) {
  for (const FirstPlan& row : first_plans) {
    const auto plan = bench.measure(blocks_problem(row.blocks, 1), Mode::fast_first, bench.limit_s);
    bench.figures.say({fmt::format("blocks {}, first plan", row.blocks),
                       plan ? plan->seconds * 1000 : bench.limit_s * 1000,
                       "ms",
                       at_most(row.goal_ms),
                       {},
                       plan ? note_of(*plan) : "no plan within the limit"});
  }
}

void fast_after_a_while(PlannerBench& bench) {
  for (const std::size_t blocks : {20, 50, 100, 200}) {
    if (bench.quick && blocks == 200) continue;
    say_after_a_while(bench, fmt::format("blocks {}", blocks), blocks, blocks_problem(blocks, 1));
    if (bench.pddl.empty()) continue;
    say_after_a_while(bench, fmt::format("random blocks {}", blocks), blocks,
                      bench.file("random-blocks", fmt::format("bw-{}-1", blocks)), known_greedy(blocks));
  }
}

void fast_others(PlannerBench& bench) {
  const auto say = [&](const std::string& name, const planner::PlanningTask& task) {
    const auto plan = bench.measure(task, Mode::fast, 3);
    const std::string note =
        plan ? fmt::format("first after {:.1f} ms; {}", plan->seconds * 1000, note_of(*plan)) : "no plan";
    const auto count = [&](std::size_t MeasuredPlan::*of) {
      return plan ? std::optional(static_cast<double>((*plan).*of)) : std::nullopt;
    };
    bench.figures.say({name + ", after 3 s", count(&MeasuredPlan::actions), "actions", {}, {}, note});
    bench.figures.say({name + ", after 3 s, makespan", count(&MeasuredPlan::steps), "steps", {}, {}, note});
  };
  say("hanoi 7", hanoi_problem(7));
  say("gripper 20", gripper_problem(42));
  say("logistics, 6 cities, 30 parcels", logistics_problem(6, 30, 1));
}

}  // namespace pizarra::bench
