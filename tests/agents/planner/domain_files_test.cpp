// The planner with the domain files of the tree, as the coordinator tells it of them.

#include <gtest/gtest.h>

#include "agents/planner/agent/planner_forms.hpp"
#include "agents/planner/graphplan/graphplan.hpp"
#include "agents/planner/task/grounding.hpp"
#include "lisp/forms/domain.hpp"
#include "tests/agents/planner/planning_domains.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::planner {
namespace {

PlanningTask task_of(const std::string& file) {
  const Result<forms::Domain> domain = forms::read_domain_file(source_dir() + "/domains/" + file);
  EXPECT_TRUE(domain) << domain.error().sentence;
  std::vector<Datum> forms;
  for (const forms::Operator& one : domain->operators) forms.push_back(forms::operator_form(one));
  const Result<std::vector<PlanningOperator>> operators = operators_from_list(Datum::list(forms));
  EXPECT_TRUE(operators) << operators.error().sentence;
  PlanningTask task{.operators = *operators, .objects = {}, .initials = {}, .goals = {}};
  for (const forms::TypedName& object : domain->objects)
    task.objects.push_back({Datum::symbol(object.name), object.type});
  return task;
}

std::size_t steps(const PlanningTask& task) {
  const Result<Problem> problem = ground(task);
  EXPECT_TRUE(problem) << problem.error().sentence;
  const Outcome outcome = Graphplan().solve(*problem, {}, [] { return false; });
  EXPECT_EQ(outcome.kind, Outcome::Kind::plan);
  EXPECT_TRUE(validate_plan(task, steps_of(*problem, outcome.steps)));
  return outcome.steps.size();
}

TEST(DomainFiles, BlocksIsPlannedWith) {
  PlanningTask task = task_of("blocks.scm");
  for (const Datum& name : facts_of("circle triangle square")) task.objects.push_back({name, "OBJECT"});
  task.initials = facts_of(
      "(on-table circle) (on-table triangle) (on-table square) (clear circle) (clear triangle) (clear square) "
      "(arm-empty)");
  task.goals = facts_of("(on circle triangle) (on triangle square)");
  EXPECT_EQ(steps(task), 4u);
}

TEST(DomainFiles, NumberedPlacesSwapsTwoCubesOverAFreePlace) {
  PlanningTask task = task_of("numbered-places.scm");
  for (const Datum& name : facts_of("circle square")) task.objects.push_back({name, "OBJECT"});
  task.initials = facts_of(
      "(at circle place-1) (at square place-2) (free place-3) (free place-4) (clear circle) (clear square) "
      "(arm-empty)");
  task.goals = facts_of("(at circle place-2) (at square place-1)");
  EXPECT_EQ(steps(task), 6u);
}

}  // namespace
}  // namespace pizarra::planner
