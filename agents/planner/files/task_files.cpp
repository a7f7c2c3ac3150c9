#include "agents/planner/files/task_files.hpp"

namespace pizarra::planner {

namespace {

std::vector<Datum> data(const Datum& items) { return {items.items().begin(), items.items().end()}; }

PlanningOperator operator_from(const Datum& form) {
  PlanningOperator out;
  out.name = form.head();
  for (const Datum& parameter : form[1].items()) {
    out.parameters.push_back({std::string(parameter[0].text()), std::string(parameter[1].text())});
  }
  out.preconditions = data(form[2]);
  out.absents = data(form[3]);
  for (const Datum& equality : form[4].items()) {
    out.equalities.push_back({equality[1], equality[2], equality.head() == "="});
  }
  out.adds = data(form[5]);
  out.deletes = data(form[6]);
  out.costs = data(form[7]);
  return out;
}

void add_objects(PlanningTask& task, const Datum& objects) {
  for (const Datum& object : objects.items()) task.objects.push_back({object[0], std::string(object[1].text())});
}

PlanningTask task_from(const forms::PlanningDomain& domain, const Datum& problem) {
  PlanningTask task;
  task.angles = domain.language != forms::PlanningLanguage::pddl;
  if (domain.language == forms::PlanningLanguage::pddl) {
    for (const Datum& type : domain.form[2].items()) {
      task.types.push_back({std::string(type[0].text()), std::string(type[1].text())});
    }
  }
  task.predicates = {"="};  // of which a problem's goals may be
  for (const Datum& predicate : domain.form[4].items()) task.predicates.emplace(predicate.head());
  add_objects(task, domain.form[3]);
  add_objects(task, problem[1]);
  for (const Datum& form : domain.form[6].items()) task.operators.push_back(operator_from(form));
  task.initials = data(domain.form[7]);
  for (const Datum& fact : problem[2].items()) task.initials.push_back(fact);
  for (const Datum& value : problem[3].items()) task.values.emplace(value[0], value[1].integer());
  task.goals = data(problem[4]);
  task.absent_goals = data(problem[5]);
  task.counts_cost = problem[6].is_symbol("cost");
  return task;
}

}  // namespace

Result<PlanningTask> read_task(const Source& domain, const Source& problem) {
  const Result<forms::PlanningFiles> files = forms::read_planning_files(domain, problem);
  if (!files) return fail(files);
  return task_from(files->domain, files->problem);
}

Result<PlanningTask> read_task_files(const std::string& domain_path, const std::string& problem_path) {
  const Result<Source> domain = forms::read_planning_source_file(domain_path);
  if (!domain) return fail(domain);
  const Result<Source> problem = forms::read_planning_source_file(problem_path);
  if (!problem) return fail(problem);
  return read_task(*domain, *problem);
}

}  // namespace pizarra::planner
