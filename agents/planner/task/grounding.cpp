#include "agents/planner/task/grounding.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <utility>

#include "agents/planner/task/ground_facts.hpp"

namespace pizarra::planner {

namespace {

constexpr std::size_t max_bindings = 4'000'000;
constexpr std::size_t bindings_between_looks = 1024;
constexpr std::size_t max_actions = 600'000;

// Of every fact, whether it can hold; actions that can then never be taken are dropped.
std::vector<char> drop_unreachable(std::vector<GroundAction>& actions, const std::vector<char>& initially) {
  std::vector<char> reachable(initially.size(), 0);
  std::vector<std::size_t> open;
  const auto reach = [&](std::size_t fact) {
    if (std::exchange(reachable[fact], 1) == 0) open.push_back(fact);
  };
  std::vector<std::vector<std::size_t>> needed_by(initially.size());
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    missing.push_back(actions[i].preconditions.size());
    for (const std::size_t fact : actions[i].preconditions) needed_by[fact].push_back(i);
    if (missing.back() == 0) std::ranges::for_each(actions[i].adds, reach);
  }
  for (std::size_t fact = 0; fact < initially.size(); ++fact) {
    if (initially[fact] != 0) reach(fact);
  }
  while (!open.empty()) {
    const std::size_t fact = open.back();
    open.pop_back();
    for (const std::size_t i : needed_by[fact]) {
      if (--missing[i] == 0) std::ranges::for_each(actions[i].adds, reach);
    }
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    if (missing[i] != 0) continue;
    if (kept != i) actions[kept] = std::move(actions[i]);
    ++kept;
  }
  actions.resize(kept);
  return reachable;
}

class Grounder {
 public:
  Grounder(const PlanningTask& task, NumberedTask numbered, const std::function<bool()>& cancelled)
      : task_(task), numbered_(std::move(numbered)), cancelled_(cancelled), facts_(numbered_) {}
  Result<Problem> run();

 private:
  Result<void> bind(const OperatorTemplate& schema, std::size_t parameter);
  void add_action(const OperatorTemplate& schema);
  bool possible(const OperatorTemplate& schema, std::size_t parameter) const;
  std::optional<std::int64_t> cost_of(const OperatorTemplate& schema) const;
  void add_complements(GroundAction& action);
  Datum name_of(const AtomTemplate& fact) const;
  bool is_complement(std::size_t fact) const { return numbered_.predicates[facts_.atom(fact).predicate].is_complement; }
  std::vector<char> asked_for() const;
  Problem finish();

  const PlanningTask& task_;
  const NumberedTask numbered_;
  const std::function<bool()>& cancelled_;
  GroundFacts facts_;
  Binding binding_;
  std::size_t bindings_tried_ = 0;
  std::vector<GroundAction> actions_;
  bool has_complements_ = false;
};

// Whether nothing that is decided by the parameters up to this one rules the operator out for ever.
bool Grounder::possible(const OperatorTemplate& schema, std::size_t parameter) const {
  for (const auto* atoms : {&schema.preconditions, &schema.absents}) {
    for (const AtomTemplate& atom : *atoms) {
      const bool decided = atom.last_parameter == parameter;
      if (decided && !facts_.changes(atom) && !facts_.holds_initially(atom, binding_)) return false;
    }
  }
  const auto object = [&](std::size_t term) {
    return term < binding_.size() ? binding_[term] : term - binding_.size();
  };
  return std::ranges::all_of(schema.equalities, [&](const EqualityTemplate& equality) {
    const bool decided = equality.last_parameter == parameter;
    return !decided || (object(equality.left) == object(equality.right)) == equality.equal;
  });
}

// None where a function of it has no value.
std::optional<std::int64_t> Grounder::cost_of(const OperatorTemplate& schema) const {
  if (!task_.counts_cost) return 1;
  std::int64_t cost = schema.fixed_cost;
  for (const AtomTemplate& function : schema.costs) {
    const std::optional<std::int64_t> value = facts_.value(function, binding_);
    if (!value) return std::nullopt;
    cost += *value;
  }
  return cost;
}

// An effect that makes a fact false makes its complement true, and the other way round.
void Grounder::add_complements(GroundAction& action) {
  const auto complements = [&](const std::vector<std::size_t>& facts) {
    std::vector<std::size_t> opposites;
    for (const std::size_t fact : facts) {
      AtomTemplate atom = facts_.atom(fact);
      atom.predicate = numbered_.predicates[atom.predicate].complement;
      if (atom.predicate != no_predicate) opposites.push_back(facts_.number(atom, {}));
    }
    return opposites;
  };
  const std::vector<std::size_t> added = complements(action.deletes);
  const std::vector<std::size_t> deleted = complements(action.adds);
  action.adds.insert(action.adds.end(), added.begin(), added.end());
  action.deletes.insert(action.deletes.end(), deleted.begin(), deleted.end());
  std::ranges::sort(action.adds);
  std::ranges::sort(action.deletes);
}

void Grounder::add_action(const OperatorTemplate& schema) {
  const std::optional<std::int64_t> cost = cost_of(schema);
  if (!cost) return;
  std::vector<AtomTemplate> changing;
  for (const auto* atoms : {&schema.preconditions, &schema.absents}) {
    std::ranges::copy_if(*atoms, std::back_inserter(changing),
                         [&](const AtomTemplate& atom) { return facts_.changes(atom); });
  }
  GroundAction action;
  std::vector<Datum> name{Datum::symbol(schema.source->name)};
  for (const std::size_t object : binding_) name.push_back(task_.objects[object].name);
  action.name = Datum::list(std::move(name));
  action.cost = *cost;
  action.preconditions = facts_.numbers(changing, binding_);
  action.adds = facts_.numbers(schema.adds, binding_);
  std::ranges::set_difference(facts_.numbers(schema.deletes, binding_), action.adds,
                              std::back_inserter(action.deletes));
  if (has_complements_) add_complements(action);
  actions_.push_back(std::move(action));
}

// Binds the parameters one after another; what never changes is checked as soon as it can be.
Result<void> Grounder::bind(const OperatorTemplate& schema, std::size_t parameter) {
  if (!possible(schema, parameter)) return {};
  if (parameter == schema.candidates.size()) {
    if (actions_.size() >= max_actions) {
      return fail("too-large", fmt::format("the task has more than {} actions: use fewer objects, or operators with "
                                           "fewer parameters",
                                           max_actions));
    }
    add_action(schema);
    return {};
  }
  for (const std::size_t object : schema.candidates[parameter]) {
    if (++bindings_tried_ > max_bindings) {
      return fail("too-large", "the operators can be bound in too many ways", Datum::symbol(schema.source->name));
    }
    if (bindings_tried_ % bindings_between_looks == 0 && cancelled_()) {
      return fail("cancelled", "another plan is wanted now");
    }
    binding_[parameter] = object;
    const Result<void> bound = bind(schema, parameter + 1);
    if (!bound) return bound;
  }
  return {};
}

Datum Grounder::name_of(const AtomTemplate& fact) const {
  const NumberedPredicate& predicate = numbered_.predicates[fact.predicate];
  std::vector<Datum> items{Datum::symbol(predicate.name)};
  for (const std::size_t object : fact.terms) items.push_back(task_.objects[object].name);
  const Datum name = Datum::list(std::move(items));
  return predicate.is_complement ? list("not"_sym, name) : name;
}

// A complement is kept only where something asks for it.
std::vector<char> Grounder::asked_for() const {
  std::vector<char> asked(facts_.size(), 0);
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    asked[fact] = is_complement(fact) ? 0 : 1;
  }
  for (const GroundAction& action : actions_) {
    for (const std::size_t fact : action.preconditions) asked[fact] = 1;
  }
  return asked;
}

Problem Grounder::finish() {
  std::vector<char> initially(facts_.size(), 0);
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    initially[fact] = facts_.holds_initially(facts_.atom(fact), {}) ? 1 : 0;
  }
  const std::vector<char> reachable = drop_unreachable(actions_, initially);
  Problem problem;
  std::vector<char> wanted(facts_.size(), 0);
  const std::vector<std::size_t> goals = facts_.numbers(numbered_.goals, {});
  for (const std::size_t fact : goals) wanted[fact] = 1;

  const std::vector<char> asked = asked_for();
  const std::size_t gone = facts_.size();
  std::vector<std::size_t> renumbered(facts_.size(), gone);
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    if ((reachable[fact] == 0 || asked[fact] == 0) && wanted[fact] == 0) continue;
    renumbered[fact] = problem.facts.size();
    problem.facts.push_back(name_of(facts_.atom(fact)));
  }
  for (GroundAction& action : actions_) {
    // Deleting what can never hold changes nothing.
    for (auto* part : {&action.preconditions, &action.adds, &action.deletes}) {
      std::erase_if(*part, [&](std::size_t fact) { return renumbered[fact] == gone; });
      for (std::size_t& fact : *part) fact = renumbered[fact];
    }
  }
  problem.actions = std::move(actions_);
  problem.initials = Bits(problem.facts.size());
  problem.goals = Bits(problem.facts.size());
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    if (renumbered[fact] != gone && initially[fact] != 0) problem.initials.set(renumbered[fact]);
  }
  for (const std::size_t fact : goals) problem.goals.set(renumbered[fact]);
  return problem;
}

Result<Problem> Grounder::run() {
  const Result<void> fits = facts_.check();
  if (!fits) return fail(fits);
  has_complements_ = std::ranges::any_of(numbered_.predicates, &NumberedPredicate::is_complement);
  // Goals have the first numbers.
  for (const AtomTemplate& goal : numbered_.goals) facts_.number(goal, {});
  for (const OperatorTemplate& schema : numbered_.operators) {
    binding_.assign(schema.candidates.size(), 0);
    const Result<void> done = bind(schema, 0);
    if (!done) return fail(done);
  }
  return finish();
}

}  // namespace

Result<Problem> ground(const PlanningTask& task, const std::function<bool()>& cancelled) {
  Result<NumberedTask> numbered = number_task(task);
  if (!numbered) return fail(numbered);
  return Grounder(task, std::move(*numbered), cancelled).run();
}

}  // namespace pizarra::planner
