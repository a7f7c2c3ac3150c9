#include <fmt/format.h>
#include <stdexcept>

#include "agents/planner/agent/planner_forms.hpp"
#include "agents/planner/optimal/optimal_search.hpp"
#include "agents/planner/task/grounding.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/bench/measure.hpp"
#include "tests/bench/planner/problems.hpp"
#include "tests/bench/planner/rows.hpp"

namespace pizarra::bench {

namespace {

constexpr int rounds = 201;
constexpr std::string_view operators_text = R"((
(operator PICK-UP (params (<ob1> OBJECT)) (preconds (clear <ob1>) (on-table <ob1>) (arm-empty))
  (effects (holding <ob1>) (del (clear <ob1>)) (del (on-table <ob1>)) (del (arm-empty))))
(operator PUT-DOWN (params (<ob1> OBJECT)) (preconds (holding <ob1>))
  (effects (clear <ob1>) (arm-empty) (on-table <ob1>) (del (holding <ob1>))))
(operator STACK (params (<ob1> OBJECT) (<ob2> OBJECT)) (preconds (clear <ob2>) (holding <ob1>))
  (effects (arm-empty) (clear <ob1>) (on <ob1> <ob2>) (del (clear <ob2>)) (del (holding <ob1>))))
(operator UNSTACK (params (<ob1> OBJECT) (<ob2> OBJECT)) (preconds (on <ob1> <ob2>) (clear <ob1>) (arm-empty))
  (effects (holding <ob1>) (clear <ob2>) (del (on <ob1> <ob2>)) (del (clear <ob1>)) (del (arm-empty))))))";

std::string facts_text(const planner::PlanningTask& task) {
  std::vector<Datum> types{"types"_sym}, initials{"initials"_sym}, goals{"goals"_sym};
  for (const planner::PlanningObject& object : task.objects)
    types.push_back(list(object.name, Datum::symbol(object.type)));
  initials.insert(initials.end(), task.initials.begin(), task.initials.end());
  goals.insert(goals.end(), task.goals.begin(), task.goals.end());
  return write(list(Datum::list(types), Datum::list(initials), Datum::list(goals)));
}

planner::Problem problem_of(const std::string& facts) {
  const Datum forms = read_one(facts).value();
  const planner::PlanningFacts read = planner::facts_from_forms(forms[0], forms[1], forms[2]).value();
  return planner::ground({planner::operators_from_list(read_one(operators_text).value()).value(), read.objects,
                          read.initials, read.goals})
      .value();
}

planner::Outcome solved(planner::OptimalSearch& search) {
  planner::Outcome outcome = search.run({}, [] { return false; });
  if (outcome.kind != planner::Outcome::Kind::plan) throw std::runtime_error("no plan for a cell");
  return outcome;
}

void plan_anew(PlannerBench& bench, std::size_t blocks) {
  const std::string facts = facts_text(blocks_problem(blocks, 1));
  const double seconds = medians_in_turns(rounds, {[&] {
                                            const planner::Problem problem = problem_of(facts);
                                            planner::OptimalSearch search(problem);
                                            planner::steps_of(problem, solved(search).steps);
                                          }})
                             .front();
  bench.figures.say({fmt::format("cell of {} blocks, plan from text", blocks), seconds * 1000, "ms", at_most(1)});
}

// The second action of the plan failed in the simplest way: the block is not where it went.
void plan_again(PlannerBench& bench, std::size_t blocks) {
  planner::Problem problem = problem_of(facts_text(blocks_problem(blocks, 1)));
  planner::OptimalSearch search(problem);
  const planner::Bits before = problem.initials;
  const planner::Bits changed = planner::after(before, problem.actions[solved(search).steps.front().front()]);
  std::vector<double> samples;
  for (int round = 0; round < rounds; ++round) {
    problem.initials = round % 2 == 0 ? changed : before;
    samples.push_back(seconds_of([&] { solved(search); }));
  }
  bench.figures.say({fmt::format("cell of {} blocks, plan again", blocks),
                     percentile(samples, 0.5) * 1e6,
                     "us",
                     at_most(300),
                     {},
                     "after one action that nobody planned for"});
}

}  // namespace

void cell(PlannerBench& bench) {
  for (const std::size_t blocks : {4, 5, 6}) plan_anew(bench, blocks);
  for (const std::size_t blocks : {4, 5, 6}) plan_again(bench, blocks);
}

}  // namespace pizarra::bench
