// pizarra-plan: the planner on files, with its word `plan`. It links Guile for what people write, but neither OpenCV
// nor Bullet, so that it starts at once.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <new>

#include "agents/planner/explanation/fewest_culprits.hpp"
#include "agents/planner/explanation/no_plan.hpp"
#include "agents/planner/explanation/why_never.hpp"
#include "agents/planner/external/external_plan.hpp"
#include "agents/planner/fast/fast_planner.hpp"
#include "agents/planner/files/task_files.hpp"
#include "agents/planner/optimal/optimal_search.hpp"
#include "agents/planner/task/grounding.hpp"
#include "agents/planner/task/plan_mode.hpp"
#include "lisp/json.hpp"
#include "lisp/plain_text.hpp"
#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/plan/memory_limit.hpp"
#include "programs/plan/plan_clock.hpp"
#include "programs/plan/plan_report.hpp"
#include "programs/plan/reading_watch.hpp"

namespace pizarra::programs {

namespace {

// A person can wait, and interrupt: only memory bounds the search.
planner::Budget unhurried(std::size_t memory_mb) {
  return {.nodes = std::size_t{1} << 60, .levels = std::size_t{1} << 30, .bytes = memory_mb << 20};
}
// How long a fast plan is made shorter where no time is given.
constexpr double improving_s = 10;
// A foreign planner is not left alone for ever, and has a moment even where reading took all the time.
constexpr double longest_s = 86'400;
constexpr double shortest_s = 0.01;
struct PlanChoices {
  std::string domain, problem;
  double limit_s = PlanClock::for_ever;
  std::string planner;
  std::size_t memory_mb = 2048;
  std::uint64_t seed = 1;
  bool optimal = false;
  bool fast = false;
  bool pddl = false;
  bool json = false;
};

PlanFormat format_of(const PlanChoices& choices) {
  if (choices.json) return PlanFormat::json;
  return choices.pddl ? PlanFormat::pddl : PlanFormat::readable;
}

ExitCode exit_code_of(const Failure& failure) {
  if (failure.symbol == "no-plan") return exit_refused;
  if (failure.symbol == "interrupted") return exit_interrupted;
  const auto is_one_of = [&](std::initializer_list<std::string_view> symbols) {
    return std::ranges::find(symbols, failure.symbol) != symbols.end();
  };
  if (is_one_of({"planner-missing", "no-folder"})) return exit_unavailable;
  const bool tried = is_one_of({"gave-up", "too-large", "bad-plan", "planner-crashed", "planner-failed", "garbage",
                                "time-out", "too-much-output"});
  return tried ? exit_failed : exit_usage;
}

Failure stopped(const PlanClock& clock) {
  if (clock.interrupted()) return {"interrupted", "interrupted before a plan was found", {}, {}};
  return {"gave-up", fmt::format("no plan was found in {:.1f} s; there may be one", clock.seconds()), {}, {}};
}

// Why the engine came back without a plan. That there is none has been proved, whatever ended the search for a reason.
Failure why_none(const planner::PlanningTask& task, const planner::Problem& problem, const planner::Outcome& outcome,
                 PlanClock& clock) {
  if (outcome.kind == planner::Outcome::Kind::cancelled) return stopped(clock);
  Failure failure = planner::explain(problem, outcome);
  if (outcome.kind != planner::Outcome::Kind::none || outcome.culprits.size() != 1) return failure;
  const Datum& culprit = problem.facts[outcome.culprits.front()];
  const std::string why = planner::why_never(task, problem, culprit, [&] { return clock.over(); });
  if (!why.empty()) failure.sentence += ": " + why;
  return failure;
}

bool wants_fast(const PlanChoices& choices, const planner::Problem& problem) {
  return choices.fast || (!choices.optimal && planner::mode_for(problem) == planner::PlanMode::fast);
}

planner::Outcome solve(const PlanChoices& choices, const planner::Problem& problem, PlanClock& clock) {
  const auto over = [&] { return clock.over(); };
  const planner::Budget budget = unhurried(choices.memory_mb);
  planner::Outcome outcome;
  if (wants_fast(choices, problem)) {
    clock.shorten(improving_s);
    outcome = planner::FastPlanner({.seed = choices.seed}).solve(problem, budget, over);
  } else {
    outcome = planner::OptimalPlanner().solve(problem, budget, over);
  }
  planner::blame_fewest(problem, budget, over, outcome);
  return outcome;
}

Result<PlanReport> search(const planner::PlanningTask& task, const PlanChoices& choices, PlanClock& clock) {
  const Result<planner::Problem> problem = planner::ground(task, [&] { return clock.over(); });
  if (!problem && problem.error().symbol == "cancelled") return fail(stopped(clock));
  if (!problem) return fail(problem);
  const planner::Outcome outcome = solve(choices, *problem, clock);
  if (outcome.kind != planner::Outcome::Kind::plan) return fail(why_none(task, *problem, outcome, clock));
  PlanReport report{.steps = planner::steps_of(*problem, outcome.steps),
                    .engine = std::string(outcome.engine.empty() ? "optimal" : outcome.engine),
                    .fewest_steps = outcome.shortest || !wants_fast(choices, *problem),
                    .out_of_memory = outcome.out_of_memory};
  const Result<void> valid = planner::validate_plan(task, report.steps);
  if (!valid) return fail(valid);
  return report;
}

Result<PlanReport> search_within_memory(const planner::PlanningTask& task, const PlanChoices& choices,
                                        PlanClock& clock) {
  const MemoryLimit limit(choices.memory_mb << 20);
  try {
    return search(task, choices, clock);
  } catch (const std::bad_alloc&) {
    return fail("gave-up",
                fmt::format("no plan was found within {} MB of memory; there may be one", choices.memory_mb));
  }
}

std::string first_word(const std::string& command) {
  const std::size_t begin = command.find_first_not_of(blanks);
  return command.substr(begin, command.find_first_of(blanks, begin) - begin);
}

Result<PlanReport> ask_planner(const planner::PlanningTask& task, const PlanChoices& choices, PlanClock& clock) {
  const double left_s = std::clamp(choices.limit_s - clock.seconds(), shortest_s, longest_s);
  const pddl_planner::ExternalPlanner planner(choices.planner,
                                              {.seconds = left_s, .memory_bytes = choices.memory_mb << 20});
  // Its time is the driver's to end, which then looks for what the planner has left.
  const Result<planner::PlanSteps> steps =
      planner::plan_externally(planner, task, [&] { return clock.over() && clock.interrupted(); });
  if (clock.interrupted()) return fail(stopped(clock));
  if (!steps && steps.error().symbol == "time-out") {
    return fail("time-out", fmt::format("the planner had no plan after {:g} s", choices.limit_s));
  }
  if (!steps) return fail(steps);
  return PlanReport{.steps = *steps, .engine = first_word(choices.planner)};
}

int tell(const Failure& failure, const PlanChoices& choices) {
  if (choices.json) fmt::print("{}\n", json_error(failure));
  return choices.json ? exit_code_of(failure) : complain(failure, exit_code_of(failure));
}

Result<planner::PlanningTask> read_in_time(const PlanChoices& choices, PlanClock& clock) {
  const ReadingWatch watch(clock, [&] { return tell(stopped(clock), choices); });
  return planner::read_task_files(choices.domain, choices.problem);
}

// The clock is gone, and what it showed with it, before anything is printed.
Result<PlanReport> make_plan(const PlanChoices& choices) {
  PlanClock clock(choices.limit_s);
  const Result<planner::PlanningTask> task = read_in_time(choices, clock);
  if (!task) return fail(task);
  Result<PlanReport> report =
      choices.planner.empty() ? search_within_memory(*task, choices, clock) : ask_planner(*task, choices, clock);
  if (!report) return report;
  report->counts_cost = task->counts_cost;
  report->cost = planner::plan_cost(*task, report->steps);
  report->seconds = clock.seconds();
  return report;
}

int run_plan(const PlanChoices& choices) {
  const Result<PlanReport> report = make_plan(choices);
  if (!report) return tell(report.error(), choices);
  fmt::print("{}", plan_text(*report, format_of(choices)));
  return exit_reached;
}

// CLI11 takes `nan` for a number.
CLI::Validator seconds_check() {
  const auto check = [](const std::string& text) {
    const std::optional<double> seconds = number_from<double>(text);
    return seconds && std::isfinite(*seconds) && *seconds > 0
               ? std::string()
               : fmt::format("a time is a number of seconds above 0, not {}", text);
  };
  return {check, "S"};
}

CLI::Validator command_check() {
  const auto check = [](const std::string& text) {
    return std::string(text.find_first_not_of(blanks) == text.npos ? "a command must be given" : "");
  };
  return {check, "COMMAND"};
}

void add_plan_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<PlanChoices>();
  CLI::App* word =
      app.add_subcommand("plan", "Plan for a domain and a problem: PDDL, or the thesis' operators and facts.");
  word->add_option("DOMAIN", choices->domain, "PDDL domain, operators (operator ...), or a cell's domain file")
      ->required();
  word->add_option("PROBLEM", choices->problem, "PDDL problem, or facts (types ...) (initials ...) (goals ...)")
      ->required();
  CLI::Option* optimal =
      word->add_flag("--optimal", choices->optimal, "The fewest parallel steps; the default up to that size");
  CLI::Option* fast = word->add_flag("--fast", choices->fast,
                                     fmt::format("A plan soon, then shorter ones; the default for more than {} actions",
                                                 planner::most_actions_for_optimal))
                          ->excludes(optimal);
  CLI::Option* seed = word->add_option("--seed", choices->seed, "The seed of all chance; 1")->check(seed_check());
  word->add_option("--time", choices->limit_s, "End after this many seconds; --fast ends after 10 by itself")
      ->check(seconds_check())
      ->type_name("S");
  word->add_option("--memory", choices->memory_mb, "End when planning takes more memory than this; 2048")
      ->check(CLI::Range(1, 1 << 20))
      ->type_name("MB");
  word->add_option(
          "--planner", choices->planner,
          "Let this command plan: {domain} and {problem} are replaced by PDDL files, {plan} by the file for its answer")
      ->check(command_check())
      ->type_name("COMMAND")
      ->excludes(optimal)
      ->excludes(fast)
      ->excludes(seed);
  CLI::Option* pddl =
      word->add_flag("--pddl", choices->pddl, "Print only the actions, one (NAME OBJECT ...) a line, in order");
  word->add_flag("--json", choices->json, "Print one JSON object")->excludes(pddl);
  word->footer(help_footer(
      "plan domain.pddl problem.pddl --time 30",
      "Exit status: 0 a plan; 1 none found in the time and memory given; 2 wrong options or files; 3 proved that "
      "there\n"
      "is no plan; 4 the planner's command cannot be started; 130 interrupted."));
  word->callback([choices, &status] { status = run_plan(*choices); });
}

}  // namespace
}  // namespace pizarra::programs

int main(int argc, char** argv) {
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_plan_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
