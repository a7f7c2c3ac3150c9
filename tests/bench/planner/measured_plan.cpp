#include "tests/bench/planner/measured_plan.hpp"

#include <chrono>
#include <ctime>
#include <fmt/format.h>
#include <poll.h>
#include <sstream>
#include <unistd.h>

#include "agents/planner/fast/fast_planner.hpp"
#include "agents/planner/optimal/optimal_search.hpp"
#include "agents/planner/task/grounding.hpp"
#include "tests/bench/child.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

// Above the limit, for a search that is slow to listen, and for validation.
constexpr double grace_s = 5;

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }
double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// A line for the parent: "-" without a plan.
std::string plan_line(const planner::PlanningTask& task, Mode mode, double limit_s) {
  const Clock::time_point start = Clock::now();
  const double cpu_start_s = cpu_seconds();
  const Result<planner::Problem> problem = planner::ground(task);
  if (!problem) return "-\n";
  double first_s = 0, cpu_s = 0;
  const auto better = [&](const planner::Outcome&) {
    if (first_s == 0) first_s = seconds_since(start);
    cpu_s = cpu_seconds() - cpu_start_s;
  };
  planner::FastPlanner fast({.seed = 1, .better = better, .first_only = mode == Mode::fast_first});
  planner::OptimalPlanner optimal;
  planner::PlanEngine& engine = mode == Mode::optimal ? static_cast<planner::PlanEngine&>(optimal) : fast;
  const planner::Budget unlimited{
      .nodes = std::size_t{1} << 60, .levels = std::size_t{1} << 30, .bytes = std::size_t{1} << 30};
  const planner::Outcome outcome = engine.solve(*problem, unlimited, [&] { return seconds_since(start) > limit_s; });
  const double seconds = first_s > 0 ? first_s : seconds_since(start);
  if (first_s == 0) cpu_s = cpu_seconds() - cpu_start_s;
  const double memory_mb = peak_memory_mb();
  if (outcome.kind != planner::Outcome::Kind::plan ||
      !planner::validate_plan(task, planner::steps_of(*problem, outcome.steps)))
    return "-\n";
  std::size_t actions = 0;
  for (const std::vector<std::size_t>& step : outcome.steps) actions += step.size();
  return fmt::format("{} {} {} {} {} {}\n", seconds, cpu_s, memory_mb, actions, outcome.steps.size(), outcome.engine);
}

}  // namespace

std::optional<MeasuredPlan> measured(const planner::PlanningTask& task, Mode mode, double limit_s) {
  Child child = Child::running([&](Pipe& parent) {
    const std::string line = plan_line(task, mode, limit_s);
    if (::write(parent.file(), line.data(), line.size()) < 0) _exit(1);
  });
  pollfd waiting{child.pipe().file(), POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>((limit_s + grace_s) * 1000)) != 1) return std::nullopt;
  MeasuredPlan plan;
  std::istringstream line(child.pipe().hear_line());
  if (!(line >> plan.seconds >> plan.cpu_s >> plan.memory_mb >> plan.actions >> plan.steps)) return std::nullopt;
  line >> plan.engine;
  return plan;
}

std::string note_of(const MeasuredPlan& plan) {
  return fmt::format("{} actions in {} steps, {}, CPU {:.4g} ms, {:.0f} MB", plan.actions, plan.steps,
                     plan.engine.empty() ? "optimal" : plan.engine, plan.cpu_s * 1000, plan.memory_mb);
}

}  // namespace pizarra::bench
