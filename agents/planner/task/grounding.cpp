#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "agents/planner/task/numbered_task.hpp"

namespace pizarra {

namespace {

constexpr std::size_t max_bindings = 4'000'000;
constexpr std::size_t bindings_between_looks = 1024;
constexpr std::size_t max_actions = 600'000;

// Numbers a fact without building its Datum: mixed radix over objects, behind the predicate.
using FactKey = std::uint64_t;

class Grounder {
 public:
  Grounder(const PlanningTask& task, NumberedTask numbered, const std::function<bool()>& cancelled)
      : task_(task), numbered_(std::move(numbered)), cancelled_(cancelled) {}
  Result<Problem> run();

 private:
  Result<void> check_keys() const;
  Result<void> bind(const OperatorTemplate& schema, std::size_t parameter);
  void add_action(const OperatorTemplate& schema);
  bool changes(const AtomTemplate& atom) const;
  bool possible(const OperatorTemplate& schema, std::size_t parameter) const;
  std::optional<std::int64_t> cost_of(const OperatorTemplate& schema) const;
  void add_complements(GroundAction& action);
  bool holds_initially(const AtomTemplate& ground) const;
  FactKey key_of(const AtomTemplate& atom, std::size_t parameter_count) const;
  std::size_t fact_of(const AtomTemplate& atom, std::size_t parameter_count);
  std::vector<std::size_t> facts_of(const std::vector<AtomTemplate>& atoms, std::size_t parameter_count);
  void prune_unreachable();
  Datum fact_name(const AtomTemplate& fact) const;
  std::vector<char> asked_for() const;
  Problem finish();

  const PlanningTask& task_;
  NumberedTask numbered_;
  const std::function<bool()>& cancelled_;
  std::unordered_set<FactKey> initial_keys_;  // looked up only, as the next two
  std::unordered_map<FactKey, std::int64_t> values_;
  std::vector<std::size_t> binding_;
  std::size_t bindings_tried_ = 0;
  std::unordered_map<FactKey, std::size_t> fact_index_;
  std::vector<AtomTemplate> facts_;  // ground
  std::vector<GroundAction> actions_;
  std::vector<char> reachable_;
  bool has_complements_ = false;
};

// Every fact must have a key of its own.
Result<void> Grounder::check_keys() const {
  std::size_t arity = 0;
  for (const NumberedPredicate& predicate : numbered_.predicates) arity = std::max(arity, predicate.arity);
  FactKey keys = numbered_.predicates.size() + 1;
  for (std::size_t i = 0; i < arity; ++i) {
    if (keys > std::numeric_limits<FactKey>::max() / (numbered_.objects.size() + 1)) {
      return fail("too-large", "too many objects for facts with so many arguments");
    }
    keys *= numbered_.objects.size() + 1;
  }
  return {};
}

FactKey Grounder::key_of(const AtomTemplate& atom, std::size_t parameter_count) const {
  FactKey key = 0;
  for (const std::size_t term : atom.terms) {
    const std::size_t object = term < parameter_count ? binding_[term] : term - parameter_count;
    key = key * numbered_.objects.size() + object;
  }
  return key * numbered_.predicates.size() + atom.predicate;
}

std::size_t Grounder::fact_of(const AtomTemplate& atom, std::size_t parameter_count) {
  const auto [found, added] = fact_index_.emplace(key_of(atom, parameter_count), facts_.size());
  if (added) {
    AtomTemplate ground{.predicate = atom.predicate, .terms = {}, .last_parameter = 0};
    for (const std::size_t term : atom.terms) {
      ground.terms.push_back(term < parameter_count ? binding_[term] : term - parameter_count);
    }
    facts_.push_back(std::move(ground));
  }
  return found->second;
}

std::vector<std::size_t> Grounder::facts_of(const std::vector<AtomTemplate>& atoms, std::size_t parameter_count) {
  std::vector<std::size_t> facts;
  for (const AtomTemplate& atom : atoms) facts.push_back(fact_of(atom, parameter_count));
  std::ranges::sort(facts);
  facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
  return facts;
}

bool Grounder::changes(const AtomTemplate& atom) const {
  const NumberedPredicate& predicate = numbered_.predicates[atom.predicate];
  return predicate.is_complement ? numbered_.predicates[predicate.complement].changes : predicate.changes;
}

// Of the initial facts and their complements; the atom may have the bound parameters.
bool Grounder::holds_initially(const AtomTemplate& atom) const {
  const NumberedPredicate& predicate = numbered_.predicates[atom.predicate];
  if (!predicate.is_complement) return initial_keys_.contains(key_of(atom, binding_.size()));
  AtomTemplate opposite = atom;
  opposite.predicate = predicate.complement;
  return !initial_keys_.contains(key_of(opposite, binding_.size()));
}

// Whether nothing that is decided by the parameters up to this one rules the operator out for ever.
bool Grounder::possible(const OperatorTemplate& schema, std::size_t parameter) const {
  for (const auto* atoms : {&schema.preconditions, &schema.absents}) {
    for (const AtomTemplate& atom : *atoms) {
      const bool decided = atom.last_parameter == parameter;
      if (decided && !changes(atom) && !holds_initially(atom)) return false;
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
    const auto found = values_.find(key_of(function, binding_.size()));
    if (found == values_.end()) return std::nullopt;
    cost += found->second;
  }
  return cost;
}

// What makes a fact false makes its complement true, and the other way round.
void Grounder::add_complements(GroundAction& action) {
  const auto complements = [&](const std::vector<std::size_t>& facts) {
    std::vector<std::size_t> opposites;
    for (const std::size_t fact : facts) {
      AtomTemplate atom = facts_[fact];
      atom.predicate = numbered_.predicates[atom.predicate].complement;
      if (atom.predicate != no_predicate) opposites.push_back(fact_of(atom, 0));
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
    std::ranges::copy_if(*atoms, std::back_inserter(changing), [&](const AtomTemplate& atom) { return changes(atom); });
  }
  GroundAction action;
  std::vector<Datum> name{Datum::symbol(schema.source->name)};
  for (const std::size_t object : binding_) name.push_back(task_.objects[object].name);
  action.name = Datum::list(std::move(name));
  action.cost = *cost;
  action.preconditions = facts_of(changing, binding_.size());
  action.adds = facts_of(schema.adds, binding_.size());
  std::ranges::set_difference(facts_of(schema.deletes, binding_.size()), action.adds,
                              std::back_inserter(action.deletes));
  if (has_complements_) add_complements(action);
  actions_.push_back(std::move(action));
}

// Binds the parameters one after another; what never changes is checked as soon as it can be.
Result<void> Grounder::bind(const OperatorTemplate& schema, std::size_t parameter) {
  if (!possible(schema, parameter)) return {};
  if (parameter == schema.candidates.size()) {
    if (actions_.size() >= max_actions) {
      return fail("too-large", fmt::format("more than {} actions: fewer objects, or operators with fewer parameters, "
                                           "would give fewer",
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
      return fail("cancelled", "something else is to be planned now");
    }
    binding_[parameter] = object;
    const Result<void> bound = bind(schema, parameter + 1);
    if (!bound) return bound;
  }
  return {};
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
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    if (holds_initially(facts_[fact])) reach(fact);
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

Datum Grounder::fact_name(const AtomTemplate& fact) const {
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
    asked[fact] = numbered_.predicates[facts_[fact].predicate].is_complement ? 0 : 1;
  }
  for (const GroundAction& action : actions_) {
    for (const std::size_t fact : action.preconditions) asked[fact] = 1;
  }
  return asked;
}

Problem Grounder::finish() {
  Problem problem;
  std::vector<char> wanted(facts_.size(), 0);
  std::vector<std::size_t> goal_facts;
  for (const AtomTemplate& goal : numbered_.goals) goal_facts.push_back(fact_index_.find(key_of(goal, 0))->second);
  for (const std::size_t fact : goal_facts) wanted[fact] = 1;

  const std::vector<char> asked = asked_for();
  const std::size_t gone = facts_.size();
  std::vector<std::size_t> renumbered(facts_.size(), gone);
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    if ((reachable_[fact] == 0 || asked[fact] == 0) && wanted[fact] == 0) continue;
    renumbered[fact] = problem.facts.size();
    problem.facts.push_back(fact_name(facts_[fact]));
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
    if (renumbered[fact] != gone && holds_initially(facts_[fact])) problem.initials.set(renumbered[fact]);
  }
  for (const std::size_t fact : goal_facts) problem.goals.set(renumbered[fact]);
  return problem;
}

Result<Problem> Grounder::run() {
  const Result<void> keys = check_keys();
  if (!keys) return fail(keys);
  has_complements_ = std::ranges::any_of(numbered_.predicates, &NumberedPredicate::is_complement);
  for (const AtomTemplate& atom : numbered_.initials) initial_keys_.insert(key_of(atom, 0));
  for (const auto& [function, value] : numbered_.values) values_.emplace(key_of(function, 0), value);
  for (const AtomTemplate& goal : numbered_.goals) fact_of(goal, 0);
  for (const OperatorTemplate& schema : numbered_.operators) {
    binding_.assign(schema.candidates.size(), 0);
    const Result<void> done = bind(schema, 0);
    if (!done) return fail(done);
  }
  prune_unreachable();
  return finish();
}

}  // namespace

Result<Problem> ground(const PlanningTask& task, const std::function<bool()>& cancelled) {
  Result<NumberedTask> numbered = number_task(task);
  if (!numbered) return fail(numbered);
  return Grounder(task, std::move(*numbered), cancelled).run();
}

}  // namespace pizarra
