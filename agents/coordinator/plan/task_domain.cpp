#include "agents/coordinator/plan/task_domain.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>

#include "agents/coordinator/plan/primitives.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::coordinator {

namespace {

std::vector<Datum> substitute_all(const std::vector<Datum>& patterns, const Bindings& bindings) {
  std::vector<Datum> facts;
  for (const Datum& pattern : patterns) facts.push_back(substitute(pattern, bindings));
  return facts;
}

// Both reports as one, the first one's symbol and sentence before.
void add(std::optional<Failure>& reported, const Failure& more) {
  if (!reported) {
    reported = more;
  } else {
    reported->place += '\n' + more.sentence + '\n' + more.place;
  }
}

// The path to an element of the perception section's part that begins so, or to the section where there is none.
std::vector<std::size_t> perception_path(const forms::Domain& domain, std::initializer_list<std::string_view> begins,
                                         std::size_t element) {
  std::vector<std::size_t> path = domain.perception_path;
  for (std::size_t i = 1; i < domain.perception.size(); ++i) {
    const Datum& part = domain.perception[i];
    std::size_t same = 0;
    for (const std::string_view name : begins) same += part.size() > same && part[same].is_symbol(name) ? 1 : 0;
    if (same == begins.size() && part.size() > element) {
      path.insert(path.end(), {i, element});
      return path;
    }
  }
  return path;
}

std::optional<Failure> check_perception(const forms::Domain& domain, const forms::Perception& perception) {
  std::optional<Failure> wrong;
  if (std::ranges::find(domain.types, perception.sees()) == domain.types.end()) {
    const std::string sentence =
        fmt::format("(sees TYPE) must name a type of the domain, and {} is none", perception.sees());
    add(wrong, domain.source.failure_at(perception_path(domain, {"sees"}, 1), "unknown-type", sentence));
  }
  const std::optional<double> cube = perception.constant("cube");
  if (!cube || *cube <= 0) {
    add(wrong, domain.source.failure_at(perception_path(domain, {"constant", "cube"}, 2), "missing-constant",
                                        "perception must say how big a cube is: (constant cube MM), above 0"));
  }
  return wrong;
}

}  // namespace

Result<TaskDomain> TaskDomain::read(const std::string& file) {
  Result<forms::Domain> domain = forms::read_domain_file(file);
  if (!domain) return fail(domain);
  forms::Arities predicates;
  for (const forms::Predicate& predicate : domain->predicates) {
    predicates.emplace_back(predicate.name, predicate.arguments.size());
  }
  forms::Arities operators;
  for (const forms::Operator& known : domain->operators) operators.emplace_back(known.name, known.params.size());
  std::optional<Failure> wrong;
  Result<forms::Perception> perception = forms::Perception::read(domain->source, predicates);
  if (!perception) {
    add(wrong, perception.error());
  } else if (const std::optional<Failure> unfit = check_perception(*domain, *perception)) {
    add(wrong, *unfit);
  }
  Result<forms::MicroTasks> micro_tasks = forms::MicroTasks::read(domain->source, operators, coordinator_motions());
  if (!micro_tasks) add(wrong, micro_tasks.error());
  if (wrong) return fail(*wrong);
  TaskDomain out;
  out.cube_mm_ = *perception->constant("cube");
  out.domain_ = std::move(*domain);
  out.perception_ = std::move(*perception);
  out.micro_tasks_ = std::move(*micro_tasks);
  return out;
}

void TaskDomain::use_cubes(double cube_mm, forms::EdgesMm edges_mm) {
  cube_mm_ = cube_mm;
  edges_mm_ = std::move(edges_mm);
  perception_.set_constant("cube", cube_mm);
  perception_.set_edges(edges_mm_);
}

double TaskDomain::edge_mm(std::string_view name) const {
  const auto known = edges_mm_.find(name);
  return known == edges_mm_.end() ? cube_mm_ : known->second;
}

std::optional<double> TaskDomain::edge_like(double opening_mm) const {
  constexpr double off_mm = 9;
  double nearest_mm = cube_mm_;
  for (const auto& [name, edge_mm] : edges_mm_) {
    if (std::abs(opening_mm - edge_mm) < std::abs(opening_mm - nearest_mm)) nearest_mm = edge_mm;
  }
  if (std::abs(opening_mm - nearest_mm) > off_mm) return std::nullopt;
  return nearest_mm;
}

std::vector<std::string> TaskDomain::objects_in(const std::vector<Datum>& goal) const {
  std::vector<std::string> names = forms::objects_in(goal);
  std::erase_if(names, [this](const std::string& name) {
    return std::ranges::find(domain_.objects, name, &forms::TypedName::name) != domain_.objects.end();
  });
  return names;
}

Result<GroundOperation> TaskDomain::ground(const Datum& operation) const {
  const forms::Operator* known = domain_.find_operator(operation.head());
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
  for (const forms::Predicate& predicate : domain_.predicates) {
    Relation relation{.name = predicate.name, .arguments = {}, .key = {}, .durable = false, .lease = {}};
    for (const forms::TypedName& argument : predicate.arguments) {
      relation.key.push_back(relation.arguments.size());
      relation.arguments.push_back({argument.name, ArgumentType::symbol});
    }
    relations.push_back(std::move(relation));
  }
  return relations;
}

std::vector<const Datum*> TaskDomain::named_places() const {
  std::vector<const Datum*> spots;
  for (const Datum& fact : perception_.facts()) {
    const bool spot = fact.is_form("spot") && fact.size() == 4;
    if (spot && fact[2].is_number() && fact[3].is_number()) spots.push_back(&fact);
  }
  return spots;
}

const Datum* TaskDomain::named_place(std::string_view name) const {
  for (const Datum* spot : named_places()) {
    if ((*spot)[1].is_symbol(name)) return spot;
  }
  return nullptr;
}

}  // namespace pizarra::coordinator
