#include "agents/planner/task/numbered_task.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include "lisp/nearest.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra::planner {

namespace {

enum class Kind : std::uint8_t { fact, function };

class Numberer {
 public:
  explicit Numberer(const PlanningTask& task) : task_(task) {}

  Result<NumberedTask> run() {
    const Result<void> objects = read_objects();
    if (!objects) return fail(objects);
    const Result<void> operators = read_operators();
    if (!operators) return fail(operators);
    const Result<void> facts = read_facts();
    if (!facts) return fail(facts);
    return std::move(out_);
  }

 private:
  Result<void> read_objects();
  Result<void> read_operators();
  Result<void> read_facts();
  Result<void> read_operator(const PlanningOperator& source);
  Result<void> read_conditions(OperatorTemplate& schema, const std::vector<std::string>& parameters);
  Result<void> read_effects(OperatorTemplate& schema, const std::vector<std::string>& parameters);
  Result<void> read_goal(const Datum& goal, bool absent);
  Result<AtomTemplate> read_atom(const Datum& atom, const std::vector<std::string>& parameters, Kind kind = Kind::fact);
  Result<std::size_t> read_term(const Datum& term, const Datum& atom, const std::vector<std::string>& parameters) const;
  std::size_t complement_of(std::size_t predicate);
  Result<void> check_predicate(const Datum& goal) const;
  Result<std::size_t> object_index(const Datum& name, const Datum& atom) const;

  const PlanningTask& task_;
  NumberedTask out_;
  std::map<std::string, std::size_t> predicate_index_, function_index_;
};

Result<void> Numberer::read_objects() {
  for (const PlanningObject& object : task_.objects) {
    if (object.name.is_list() || is_variable(object.name)) {
      return fail("bad-task", "an object is a name, not " + write(object.name), object.name);
    }
    if (!out_.objects.emplace(object.name, out_.objects.size()).second) {
      return fail("bad-task", write(object.name) + " is listed twice among the objects", object.name);
    }
  }
  return {};
}

Result<std::size_t> Numberer::object_index(const Datum& name, const Datum& atom) const {
  const auto found = out_.objects.find(name);
  if (found != out_.objects.end()) return found->second;
  std::vector<std::string> names;
  for (const PlanningObject& object : task_.objects) names.push_back(write(object.name));
  const std::string nearest = nearest_name(write(name), names);
  return fail("unknown-object",
              fmt::format("{} in {} is not among the objects{}", write(name), write(atom),
                          nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
              name);
}

// A goal that nothing speaks of is a slip of the pen rather than out of reach.
Result<void> Numberer::check_predicate(const Datum& goal) const {
  const std::string predicate(goal.head());
  if (predicate.empty() || predicate_index_.contains(predicate) || task_.predicates.contains(predicate)) return {};
  std::vector<std::string> names;
  for (const auto& [name, index] : predicate_index_) names.push_back(name);
  const std::string nearest = nearest_name(goal.head(), names);
  return fail("unknown-predicate",
              fmt::format("nothing is said about `{}` by any operator or initial fact{}", goal.head(),
                          nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
              goal);
}

// An argument: a parameter's index, or an object's behind the parameters.
Result<std::size_t> Numberer::read_term(const Datum& term, const Datum& atom,
                                        const std::vector<std::string>& parameters) const {
  const auto parameter = std::ranges::find(parameters, term.text());
  if (term.is_symbol() && parameter != parameters.end()) {
    return static_cast<std::size_t>(parameter - parameters.begin());
  }
  if (is_variable(term))
    return fail("bad-task", fmt::format("{} in {} is no parameter", write(term), write(atom)), atom);
  const Result<std::size_t> object = object_index(term, atom);
  if (!object) return fail(object);
  return parameters.size() + *object;
}

Result<AtomTemplate> Numberer::read_atom(const Datum& atom, const std::vector<std::string>& parameters, Kind kind) {
  if (atom.head().empty()) return fail("bad-task", "a fact is (PREDICATE OBJECT ...), not " + write(atom), atom);
  const std::string name(atom.head());
  if (name == "not" || name == "and" || name == "or") {
    return fail("bad-task", fmt::format("`{}` cannot stand where a fact is expected: {}", name, write(atom)), atom);
  }
  auto& index = kind == Kind::fact ? predicate_index_ : function_index_;
  const auto [known, is_new] = index.emplace(name, out_.predicates.size());
  if (is_new) out_.predicates.push_back({.name = name, .arity = atom.size() - 1});
  const std::size_t arity = out_.predicates[known->second].arity;
  if (arity != atom.size() - 1) {
    return fail("bad-task",
                fmt::format("`{}` has {} arguments elsewhere, and {} in {}", name, arity, atom.size() - 1, write(atom)),
                atom);
  }
  AtomTemplate read{.predicate = known->second, .terms = {}, .last_parameter = 0};
  for (const Datum& argument : atom.items().subspan(1)) {
    const Result<std::size_t> term = read_term(argument, atom, parameters);
    if (!term) return fail(term);
    read.terms.push_back(*term);
    if (*term < parameters.size()) read.last_parameter = std::max(read.last_parameter, *term + 1);
  }
  return read;
}

std::size_t Numberer::complement_of(std::size_t predicate) {
  if (out_.predicates[predicate].complement == no_predicate) {
    out_.predicates[predicate].complement = out_.predicates.size();
    NumberedPredicate opposite = out_.predicates[predicate];
    opposite.complement = predicate;
    opposite.is_complement = true;
    out_.predicates.push_back(std::move(opposite));
  }
  return out_.predicates[predicate].complement;
}

Result<void> Numberer::read_conditions(OperatorTemplate& schema, const std::vector<std::string>& parameters) {
  for (const Datum& atom : schema.source->preconditions) {
    Result<AtomTemplate> read = read_atom(atom, parameters);
    if (!read) return fail(read);
    schema.preconditions.push_back(std::move(*read));
  }
  for (const Datum& atom : schema.source->absents) {
    Result<AtomTemplate> read = read_atom(atom, parameters);
    if (!read) return fail(read);
    read->predicate = complement_of(read->predicate);
    schema.absents.push_back(std::move(*read));
  }
  for (const PlanningEquality& equality : schema.source->equalities) {
    const Datum shown = list("="_sym, equality.left, equality.right);
    const Result<std::size_t> left = read_term(equality.left, shown, parameters);
    if (!left) return fail(left);
    const Result<std::size_t> right = read_term(equality.right, shown, parameters);
    if (!right) return fail(right);
    std::size_t last_parameter = 0;
    for (const std::size_t term : {*left, *right}) {
      if (term < parameters.size()) last_parameter = std::max(last_parameter, term + 1);
    }
    schema.equalities.push_back({*left, *right, last_parameter, equality.equal});
  }
  return {};
}

Result<void> Numberer::read_effects(OperatorTemplate& schema, const std::vector<std::string>& parameters) {
  const std::pair<const std::vector<Datum>&, std::vector<AtomTemplate>&> parts[] = {
      {schema.source->adds, schema.adds}, {schema.source->deletes, schema.deletes}};
  for (const auto& [atoms, templates] : parts) {
    for (const Datum& atom : atoms) {
      Result<AtomTemplate> read = read_atom(atom, parameters);
      if (!read) return fail(read);
      out_.predicates[read->predicate].changes = true;
      templates.push_back(std::move(*read));
    }
  }
  for (const Datum& cost : schema.source->costs) {
    if (cost.is_integer()) {
      schema.fixed_cost += cost.integer();
      continue;
    }
    Result<AtomTemplate> function = read_atom(cost, parameters, Kind::function);
    if (!function) return fail(function);
    schema.costs.push_back(std::move(*function));
  }
  return {};
}

Result<void> Numberer::read_operator(const PlanningOperator& source) {
  OperatorTemplate schema;
  schema.source = &source;
  std::vector<std::string> parameters;
  for (const PlanningParameter& parameter : source.parameters) {
    if (std::ranges::find(parameters, parameter.variable) != parameters.end()) {
      return fail("bad-task", fmt::format("{} has {} twice among its parameters", source.name, parameter.variable),
                  Datum::symbol(source.name));
    }
    parameters.push_back(parameter.variable);
    schema.candidates.emplace_back();
    for (std::size_t i = 0; i < task_.objects.size(); ++i) {
      if (is_subtype(task_.types, task_.objects[i].type, parameter.type)) schema.candidates.back().push_back(i);
    }
  }
  const Result<void> conditions = read_conditions(schema, parameters);
  if (!conditions) return conditions;
  const Result<void> effects = read_effects(schema, parameters);
  if (!effects) return effects;
  out_.operators.push_back(std::move(schema));
  return {};
}

Result<void> Numberer::read_operators() {
  for (const PlanningOperator& source : task_.operators) {
    const Result<void> read = read_operator(source);
    if (!read) return read;
  }
  return {};
}

Result<void> Numberer::read_goal(const Datum& goal, bool absent) {
  const Result<void> spoken_of = check_predicate(goal);
  if (!spoken_of) return spoken_of;
  Result<AtomTemplate> read = read_atom(goal, {});
  if (!read) return fail(read);
  if (absent) read->predicate = complement_of(read->predicate);
  out_.goals.push_back(std::move(*read));
  return {};
}

Result<void> Numberer::read_facts() {
  for (const Datum& fact : task_.initials) {
    Result<AtomTemplate> read = read_atom(fact, {});
    if (!read) return fail(read);
    out_.initials.push_back(std::move(*read));
  }
  for (const Datum& goal : task_.goals) {
    const Result<void> read = read_goal(goal, false);
    if (!read) return read;
  }
  for (const Datum& goal : task_.absent_goals) {
    const Result<void> read = read_goal(goal, true);
    if (!read) return read;
  }
  for (const auto& [function, value] : task_.values) {
    Result<AtomTemplate> read = read_atom(function, {}, Kind::function);
    if (!read) return fail(read);
    out_.values.emplace_back(std::move(*read), value);
  }
  return {};
}

}  // namespace

Result<NumberedTask> number_task(const PlanningTask& task) { return Numberer(task).run(); }

}  // namespace pizarra::planner
