#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

#include "agents/planner/problem.hpp"
#include "lisp/nearest.hpp"
#include "lisp/pattern.hpp"
#include "lisp/writer.hpp"

namespace pizarra {

namespace {

constexpr std::size_t max_bindings = 4'000'000;
constexpr std::size_t max_actions = 50'000;

// An atom of an operator: its arguments are parameters (index) or objects (index behind the parameters).
struct Template {
  std::size_t predicate = 0;
  std::vector<std::size_t> terms;
  std::size_t last_parameter = 0;  // 1 + the highest parameter it mentions, 0: none
};

struct Schema {
  const PlanningOperator* source = nullptr;
  std::vector<std::vector<std::size_t>> candidates;  // of every parameter: the objects of its type
  std::vector<Template> preconditions, adds, deletes;
};

struct KnownPredicate {
  std::size_t index = 0;
  std::size_t arity = 0;
  bool changes = false;
};

// Numbers a fact without building its Datum: mixed radix over objects, behind the predicate.
using FactKey = std::uint64_t;

class Grounder {
 public:
  explicit Grounder(const PlanningTask& task) : task_(task) {}
  Result<Problem> run();

 private:
  Result<void> read_objects();
  Result<void> read_operators();
  Result<void> read_facts();
  Result<void> check_keys() const;
  Result<Template> read_atom(const Datum& atom, const std::vector<std::string>& parameters, bool new_predicates);
  Result<std::size_t> object_index(const Datum& name, const Datum& atom) const;
  Result<void> instantiate(const Schema& schema);
  Result<void> bind(const Schema& schema, std::size_t parameter);
  void add_action(const Schema& schema);
  bool holds(const Template& atom);
  FactKey key_of(const Template& atom, std::size_t parameter_count) const;
  std::size_t fact_of(const Template& atom, std::size_t parameter_count);
  std::vector<std::size_t> facts_of(const std::vector<Template>& atoms, std::size_t parameter_count);
  void prune_unreachable();
  Problem finish();

  const PlanningTask& task_;
  std::map<Datum, std::size_t> objects_;
  std::map<std::string, KnownPredicate> predicates_;
  std::vector<const std::string*> predicate_names_;
  std::vector<Schema> schemas_;
  std::vector<Template> initials_, goals_;
  std::set<FactKey> initial_keys_;

  std::vector<std::size_t> binding_;
  std::size_t bindings_tried_ = 0;
  std::unordered_map<FactKey, std::size_t> fact_index_;  // looked up only, never walked through
  std::vector<Template> facts_;                          // ground
  std::vector<GroundAction> actions_;
  std::vector<char> reachable_;
};

Result<void> Grounder::read_objects() {
  for (const PlanningObject& object : task_.objects) {
    if (object.name.is_list() || is_variable(object.name)) {
      return fail("bad-task", "an object is a name, not " + write(object.name), object.name);
    }
    if (!objects_.emplace(object.name, objects_.size()).second) {
      return fail("bad-task", write(object.name) + " is listed twice among the objects", object.name);
    }
  }
  return {};
}

Result<std::size_t> Grounder::object_index(const Datum& name, const Datum& atom) const {
  const auto found = objects_.find(name);
  if (found != objects_.end()) return found->second;
  std::vector<std::string> names;
  for (const PlanningObject& object : task_.objects) names.push_back(write(object.name));
  const std::string nearest = nearest_name(write(name), names);
  return fail("unknown-object",
              fmt::format("{} in {} is not among the objects{}", write(name), write(atom),
                          nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
              name);
}

Result<Template> Grounder::read_atom(const Datum& atom, const std::vector<std::string>& parameters,
                                     bool new_predicates) {
  if (atom.head().empty()) return fail("bad-task", "a fact is (PREDICATE OBJECT ...), not " + write(atom), atom);
  const std::string name(atom.head());
  if (name == "not" || name == "and" || name == "or") {
    return fail("bad-task", fmt::format("`{}` cannot stand where a fact is expected: {}", name, write(atom)), atom);
  }
  auto known = predicates_.find(name);
  if (known == predicates_.end() && !new_predicates) {
    std::vector<std::string> names;
    for (const auto& [other, predicate] : predicates_) names.push_back(other);
    const std::string nearest = nearest_name(name, names);
    return fail("unknown-predicate",
                fmt::format("nothing is said about `{}` by any operator or initial fact{}", name,
                            nearest.empty() ? "" : fmt::format("; did you mean {}?", nearest)),
                atom);
  }
  if (known == predicates_.end()) {
    known = predicates_.emplace(name, KnownPredicate{predicates_.size(), atom.size() - 1, false}).first;
  }
  if (known->second.arity != atom.size() - 1) {
    return fail("bad-task",
                fmt::format("`{}` has {} arguments elsewhere, and {} in {}", name, known->second.arity, atom.size() - 1,
                            write(atom)),
                atom);
  }
  Template read{.predicate = known->second.index, .terms = {}, .last_parameter = 0};
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

Result<void> Grounder::read_operators() {
  for (const PlanningOperator& source : task_.operators) {
    Schema schema{.source = &source, .candidates = {}, .preconditions = {}, .adds = {}, .deletes = {}};
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
    const std::tuple<const std::vector<Datum>&, std::vector<Template>&, bool> parts[] = {
        {source.preconditions, schema.preconditions, false},
        {source.adds, schema.adds, true},
        {source.deletes, schema.deletes, true}};
    for (const auto& [atoms, templates, changes] : parts) {
      for (const Datum& atom : atoms) {
        Result<Template> read = read_atom(atom, parameters, true);
        if (!read) return fail(read);
        if (changes) predicates_.find(std::string(atom.head()))->second.changes = true;
        templates.push_back(std::move(*read));
      }
    }
    schemas_.push_back(std::move(schema));
  }
  return {};
}

Result<void> Grounder::read_facts() {
  for (const Datum& fact : task_.initials) {
    Result<Template> read = read_atom(fact, {}, true);
    if (!read) return fail(read);
    initials_.push_back(std::move(*read));
  }
  for (const Datum& goal : task_.goals) {
    Result<Template> read = read_atom(goal, {}, false);
    if (!read) return fail(read);
    goals_.push_back(std::move(*read));
  }
  return {};
}

// Every fact must have a key of its own.
Result<void> Grounder::check_keys() const {
  std::size_t arity = 0;
  for (const auto& [name, predicate] : predicates_) arity = std::max(arity, predicate.arity);
  FactKey keys = predicates_.size() + 1;
  for (std::size_t i = 0; i < arity; ++i) {
    if (keys > std::numeric_limits<FactKey>::max() / (objects_.size() + 1)) {
      return fail("too-large", "too many objects for facts with so many arguments");
    }
    keys *= objects_.size() + 1;
  }
  return {};
}

FactKey Grounder::key_of(const Template& atom, std::size_t parameter_count) const {
  FactKey key = 0;
  for (const std::size_t term : atom.terms) {
    const std::size_t object = term < parameter_count ? binding_[term] : term - parameter_count;
    key = key * objects_.size() + object;
  }
  return key * predicates_.size() + atom.predicate;
}

bool Grounder::holds(const Template& atom) { return initial_keys_.contains(key_of(atom, binding_.size())); }

std::size_t Grounder::fact_of(const Template& atom, std::size_t parameter_count) {
  const auto [found, added] = fact_index_.emplace(key_of(atom, parameter_count), facts_.size());
  if (added) {
    Template ground{.predicate = atom.predicate, .terms = {}, .last_parameter = 0};
    for (const std::size_t term : atom.terms) {
      ground.terms.push_back(term < parameter_count ? binding_[term] : term - parameter_count);
    }
    facts_.push_back(std::move(ground));
  }
  return found->second;
}

std::vector<std::size_t> Grounder::facts_of(const std::vector<Template>& atoms, std::size_t parameter_count) {
  std::vector<std::size_t> facts;
  for (const Template& atom : atoms) facts.push_back(fact_of(atom, parameter_count));
  std::ranges::sort(facts);
  facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
  return facts;
}

void Grounder::add_action(const Schema& schema) {
  std::vector<Template> changing;
  for (const Template& atom : schema.preconditions) {
    if (predicates_.find(*predicate_names_[atom.predicate])->second.changes) changing.push_back(atom);
  }
  GroundAction action;
  std::vector<Datum> name{Datum::symbol(schema.source->name)};
  for (const std::size_t object : binding_) name.push_back(task_.objects[object].name);
  action.name = Datum::list(std::move(name));
  action.preconditions = facts_of(changing, binding_.size());
  action.adds = facts_of(schema.adds, binding_.size());
  std::ranges::set_difference(facts_of(schema.deletes, binding_.size()), action.adds,
                              std::back_inserter(action.deletes));
  actions_.push_back(std::move(action));
}

// Binds the parameters one after another; what never changes is checked as soon as it can be.
Result<void> Grounder::bind(const Schema& schema, std::size_t parameter) {
  for (const Template& atom : schema.preconditions) {
    const bool decided = atom.last_parameter == parameter;
    if (decided && !predicates_.find(*predicate_names_[atom.predicate])->second.changes && !holds(atom)) return {};
  }
  if (parameter == schema.candidates.size()) {
    if (actions_.size() >= max_actions) return fail("too-large", fmt::format("more than {} actions", max_actions));
    add_action(schema);
    return {};
  }
  for (const std::size_t object : schema.candidates[parameter]) {
    if (++bindings_tried_ > max_bindings) {
      return fail("too-large", "the operators can be bound in too many ways", Datum::symbol(schema.source->name));
    }
    binding_[parameter] = object;
    const Result<void> bound = bind(schema, parameter + 1);
    if (!bound) return bound;
  }
  return {};
}

Result<void> Grounder::instantiate(const Schema& schema) {
  binding_.assign(schema.candidates.size(), 0);
  return bind(schema, 0);
}

// Reachability if nothing were ever deleted; actions beyond it are dropped.
void Grounder::prune_unreachable() {
  reachable_.assign(facts_.size(), 0);
  binding_.clear();
  std::vector<std::size_t> open;
  const auto reach = [&](std::size_t fact) {
    if (std::exchange(reachable_[fact], 1) == 0) open.push_back(fact);
  };
  std::vector<std::vector<std::size_t>> needed_by(facts_.size());
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    missing.push_back(actions_[i].preconditions.size());
    for (const std::size_t fact : actions_[i].preconditions) needed_by[fact].push_back(i);
    if (missing.back() == 0) std::ranges::for_each(actions_[i].adds, reach);
  }
  for (const Template& atom : initials_) {
    const auto found = fact_index_.find(key_of(atom, 0));
    if (found != fact_index_.end()) reach(found->second);
  }
  while (!open.empty()) {
    const std::size_t fact = open.back();
    open.pop_back();
    for (const std::size_t i : needed_by[fact]) {
      if (--missing[i] == 0) std::ranges::for_each(actions_[i].adds, reach);
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < actions_.size(); ++i) {
    if (missing[i] != 0) continue;
    if (kept != i) actions_[kept] = std::move(actions_[i]);
    ++kept;
  }
  actions_.resize(kept);
}

Problem Grounder::finish() {
  Problem problem;
  std::vector<char> wanted(facts_.size(), 0);
  std::vector<std::size_t> goal_facts;
  for (const Template& goal : goals_) goal_facts.push_back(fact_index_.find(key_of(goal, 0))->second);
  for (const std::size_t fact : goal_facts) wanted[fact] = 1;

  std::vector<std::size_t> renumbered(facts_.size(), facts_.size());
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    if (reachable_[fact] == 0 && wanted[fact] == 0) continue;
    renumbered[fact] = problem.facts.size();
    std::vector<Datum> items{Datum::symbol(*predicate_names_[facts_[fact].predicate])};
    for (const std::size_t object : facts_[fact].terms) items.push_back(task_.objects[object].name);
    problem.facts.push_back(Datum::list(std::move(items)));
  }
  for (GroundAction& action : actions_) {
    // Deleting what can never hold changes nothing.
    std::erase_if(action.deletes, [&](std::size_t fact) { return renumbered[fact] == facts_.size(); });
    for (auto* part : {&action.preconditions, &action.adds, &action.deletes}) {
      for (std::size_t& fact : *part) fact = renumbered[fact];
    }
  }
  problem.actions = std::move(actions_);
  problem.initials = Bits(problem.facts.size());
  problem.goals = Bits(problem.facts.size());
  for (const Template& atom : initials_) {
    const auto found = fact_index_.find(key_of(atom, 0));
    if (found != fact_index_.end() && renumbered[found->second] < facts_.size()) {
      problem.initials.set(renumbered[found->second]);
    }
  }
  for (const std::size_t fact : goal_facts) problem.goals.set(renumbered[fact]);
  return problem;
}

Result<Problem> Grounder::run() {
  const Result<void> objects = read_objects();
  if (!objects) return fail(objects);
  const Result<void> operators = read_operators();
  if (!operators) return fail(operators);
  const Result<void> facts = read_facts();
  if (!facts) return fail(facts);
  const Result<void> keys = check_keys();
  if (!keys) return fail(keys);

  predicate_names_.resize(predicates_.size());
  for (const auto& [name, predicate] : predicates_) predicate_names_[predicate.index] = &name;
  for (const Template& atom : initials_) initial_keys_.insert(key_of(atom, 0));
  for (const Template& goal : goals_) fact_of(goal, 0);
  for (const Schema& schema : schemas_) {
    const Result<void> done = instantiate(schema);
    if (!done) return fail(done);
  }
  prune_unreachable();
  return finish();
}

}  // namespace

Result<Problem> ground(const PlanningTask& task) { return Grounder(task).run(); }

bool interfere(const GroundAction& a, const GroundAction& b) {
  const auto spoils = [](const GroundAction& by, const GroundAction& of) {
    return std::ranges::any_of(by.deletes, [&](std::size_t fact) {
      return std::ranges::binary_search(of.preconditions, fact) || std::ranges::binary_search(of.adds, fact);
    });
  };
  return spoils(a, b) || spoils(b, a);
}

PlanSteps steps_of(const Problem& problem, const std::vector<std::vector<std::size_t>>& steps) {
  PlanSteps named;
  for (const std::vector<std::size_t>& step : steps) {
    named.emplace_back();
    for (const std::size_t action : step) named.back().push_back(problem.actions[action].name);
  }
  return named;
}

}  // namespace pizarra
