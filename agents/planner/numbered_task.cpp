#include "agents/planner/numbered_task.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include "lisp/nearest.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

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
  Result<AtomTemplate> read_atom(const Datum& atom, const std::vector<std::string>& parameters);
  Result<void> check_predicate(const Datum& goal) const;
  Result<std::size_t> object_index(const Datum& name, const Datum& atom) const;

  const PlanningTask& task_;
  NumberedTask out_;
  std::map<std::string, std::size_t> predicate_index_;
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
  if (goal.head().empty() || predicate_index_.contains(std::string(goal.head()))) return {};
  std::vector<std::string> names;
  for (const NumberedPredicate& predicate : out_.predicates) names.push_back(predicate.name);
  const std::string nearest = nearest_name(goal.head(), names);
  return fail("unknown-predicate",
              fmt::format("nothing is said about `{}` by any operator or initial fact{}", goal.head(),
                          nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
              goal);
}

Result<AtomTemplate> Numberer::read_atom(const Datum& atom, const std::vector<std::string>& parameters) {
  if (atom.head().empty()) return fail("bad-task", "a fact is (PREDICATE OBJECT ...), not " + write(atom), atom);
  const std::string name(atom.head());
  if (name == "not" || name == "and" || name == "or") {
    return fail("bad-task", fmt::format("`{}` cannot stand where a fact is expected: {}", name, write(atom)), atom);
  }
  const auto [known, is_new] = predicate_index_.emplace(name, out_.predicates.size());
  if (is_new) out_.predicates.push_back({name, atom.size() - 1, false});
  const std::size_t arity = out_.predicates[known->second].arity;
  if (arity != atom.size() - 1) {
    return fail("bad-task",
                fmt::format("`{}` has {} arguments elsewhere, and {} in {}", name, arity, atom.size() - 1, write(atom)),
                atom);
  }
  AtomTemplate read{.predicate = known->second, .terms = {}, .last_parameter = 0};
  for (const Datum& term : atom.items().subspan(1)) {
    const auto parameter = std::ranges::find(parameters, std::string(term.text()));
    if (term.is_symbol() && parameter != parameters.end()) {
      read.terms.push_back(static_cast<std::size_t>(parameter - parameters.begin()));
      read.last_parameter = std::max(read.last_parameter, read.terms.back() + 1);
    } else if (is_variable(term)) {
      return fail("bad-task", fmt::format("{} in {} is no parameter", write(term), write(atom)), atom);
    } else {
      const Result<std::size_t> object = object_index(term, atom);
      if (!object) return fail(object);
      read.terms.push_back(parameters.size() + *object);
    }
  }
  return read;
}

Result<void> Numberer::read_operators() {
  for (const PlanningOperator& source : task_.operators) {
    OperatorTemplate schema{.source = &source, .candidates = {}, .preconditions = {}, .adds = {}, .deletes = {}};
    std::vector<std::string> parameters;
    for (const PlanningParameter& parameter : source.parameters) {
      if (std::ranges::find(parameters, parameter.variable) != parameters.end()) {
        return fail("bad-task", fmt::format("{} has {} twice among its parameters", source.name, parameter.variable),
                    Datum::symbol(source.name));
      }
      parameters.push_back(parameter.variable);
      schema.candidates.emplace_back();
      for (std::size_t i = 0; i < task_.objects.size(); ++i) {
        if (task_.objects[i].type == parameter.type) schema.candidates.back().push_back(i);
      }
    }
    const std::tuple<const std::vector<Datum>&, std::vector<AtomTemplate>&, bool> parts[] = {
        {source.preconditions, schema.preconditions, false},
        {source.adds, schema.adds, true},
        {source.deletes, schema.deletes, true}};
    for (const auto& [atoms, templates, changes] : parts) {
      for (const Datum& atom : atoms) {
        Result<AtomTemplate> read = read_atom(atom, parameters);
        if (!read) return fail(read);
        if (changes) out_.predicates[read->predicate].changes = true;
        templates.push_back(std::move(*read));
      }
    }
    out_.operators.push_back(std::move(schema));
  }
  return {};
}

Result<void> Numberer::read_facts() {
  for (const Datum& fact : task_.initials) {
    Result<AtomTemplate> read = read_atom(fact, {});
    if (!read) return fail(read);
    out_.initials.push_back(std::move(*read));
  }
  for (const Datum& goal : task_.goals) {
    const Result<void> spoken_of = check_predicate(goal);
    if (!spoken_of) return spoken_of;
    Result<AtomTemplate> read = read_atom(goal, {});
    if (!read) return fail(read);
    out_.goals.push_back(std::move(*read));
  }
  return {};
}

}  // namespace

Result<NumberedTask> number_task(const PlanningTask& task) { return Numberer(task).run(); }

}  // namespace pizarra
