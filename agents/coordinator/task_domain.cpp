#include "agents/coordinator/task_domain.hpp"

#include <fmt/format.h>

#include "agents/coordinator/primitives.hpp"
#include "lisp/pattern.hpp"

namespace pizarra {

namespace {

std::vector<Datum> substitute_all(const std::vector<Datum>& patterns, const Bindings& bindings) {
  std::vector<Datum> facts;
  for (const Datum& pattern : patterns) facts.push_back(substitute(pattern, bindings));
  return facts;
}

}  // namespace

Result<TaskDomain> TaskDomain::read(const std::string& file) {
  Result<Domain> domain = read_domain_file(file);
  if (!domain) return fail(domain);
  Arities predicates;
  for (const Predicate& predicate : domain->predicates) {
    predicates.emplace_back(predicate.name, predicate.arguments.size());
  }
  Arities operators;
  for (const Operator& known : domain->operators) operators.emplace_back(known.name, known.params.size());
  Result<Perception> perception = Perception::read(domain->source, predicates);
  if (!perception) return fail(perception);
  Result<MicroTasks> micro_tasks = MicroTasks::read(domain->source, operators, primitive_arities());
  if (!micro_tasks) return fail(micro_tasks);
  const std::optional<double> cube = perception->constant("cube");
  if (!cube || *cube <= 0) {
    return fail(domain->source.failure_at(domain->perception_path, "missing-constant",
                                          "perception must say how big a cube is: (constant cube MM)"));
  }
  TaskDomain out;
  out.domain_ = std::move(*domain);
  out.perception_ = std::move(*perception);
  out.micro_tasks_ = std::move(*micro_tasks);
  out.cube_mm_ = *cube;
  return out;
}

Result<GroundOperation> TaskDomain::ground(const Datum& operation) const {
  const Operator* known = domain_.find_operator(operation.head());
  if (!known) return fail("unknown-operator", "the domain has no such operator", operation);
  if (operation.size() != known->params.size() + 1) {
    return fail("wrong-arity", fmt::format("{} takes {} arguments", known->name, known->params.size()), operation);
  }
  Bindings bindings;
  for (std::size_t i = 0; i < known->params.size(); ++i) bindings.bind(known->params[i].name, operation[i + 1]);
  return GroundOperation{operation, substitute_all(known->preconds, bindings), substitute_all(known->adds, bindings),
                         substitute_all(known->deletes, bindings)};
}

std::vector<Relation> TaskDomain::relations() const {
  std::vector<Relation> relations;
  for (const Predicate& predicate : domain_.predicates) {
    Relation relation{.name = predicate.name, .arguments = {}, .key = {}, .durable = false, .lease = {}};
    for (const TypedName& argument : predicate.arguments) {
      relation.key.push_back(relation.arguments.size());
      relation.arguments.push_back({argument.name, ArgumentType::symbol});
    }
    relations.push_back(std::move(relation));
  }
  return relations;
}

const Datum* TaskDomain::spot(std::string_view name) const {
  for (const Datum& fact : perception_.facts()) {
    const bool place = fact.is_form("spot") && fact.size() == 4 && fact[1].is_symbol(name);
    if (place && fact[2].is_number() && fact[3].is_number()) return &fact;
  }
  return nullptr;
}

}  // namespace pizarra
