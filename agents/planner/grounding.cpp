#include <algorithm>
#include <fmt/format.h>
#include <limits>
#include <set>
#include <unordered_map>
#include <utility>

#include "agents/planner/numbered_task.hpp"

namespace pizarra {

namespace {

constexpr std::size_t max_bindings = 4'000'000;
constexpr std::size_t max_actions = 50'000;

// Numbers a fact without building its Datum: mixed radix over objects, behind the predicate.
using FactKey = std::uint64_t;

class Grounder {
 public:
  Grounder(const PlanningTask& task, NumberedTask numbered) : task_(task), numbered_(std::move(numbered)) {}
  Result<Problem> run();

 private:
  Result<void> check_keys() const;
  Result<void> bind(const OperatorTemplate& schema, std::size_t parameter);
  void add_action(const OperatorTemplate& schema);
  bool changes(const AtomTemplate& atom) const { return numbered_.predicates[atom.predicate].changes; }
  FactKey key_of(const AtomTemplate& atom, std::size_t parameter_count) const;
  std::size_t fact_of(const AtomTemplate& atom, std::size_t parameter_count);
  std::vector<std::size_t> facts_of(const std::vector<AtomTemplate>& atoms, std::size_t parameter_count);
  void prune_unreachable();
  Datum fact_name(const AtomTemplate& fact) const;
  Problem finish();

  const PlanningTask& task_;
  NumberedTask numbered_;
  std::set<FactKey> initial_keys_;
  std::vector<std::size_t> binding_;
  std::size_t bindings_tried_ = 0;
  std::unordered_map<FactKey, std::size_t> fact_index_;  // looked up only, never walked through
  std::vector<AtomTemplate> facts_;                      // ground
  std::vector<GroundAction> actions_;
  std::vector<char> reachable_;
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

void Grounder::add_action(const OperatorTemplate& schema) {
  std::vector<AtomTemplate> changing;
  for (const AtomTemplate& atom : schema.preconditions) {
    if (changes(atom)) changing.push_back(atom);
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
Result<void> Grounder::bind(const OperatorTemplate& schema, std::size_t parameter) {
  for (const AtomTemplate& atom : schema.preconditions) {
    const bool decided = atom.last_parameter == parameter;
    if (decided && !changes(atom) && !initial_keys_.contains(key_of(atom, binding_.size()))) return {};
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
  for (const AtomTemplate& atom : numbered_.initials) {
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

Datum Grounder::fact_name(const AtomTemplate& fact) const {
  std::vector<Datum> items{Datum::symbol(numbered_.predicates[fact.predicate].name)};
  for (const std::size_t object : fact.terms) items.push_back(task_.objects[object].name);
  return Datum::list(std::move(items));
}

Problem Grounder::finish() {
  Problem problem;
  std::vector<char> wanted(facts_.size(), 0);
  std::vector<std::size_t> goal_facts;
  for (const AtomTemplate& goal : numbered_.goals) goal_facts.push_back(fact_index_.find(key_of(goal, 0))->second);
  for (const std::size_t fact : goal_facts) wanted[fact] = 1;

  std::vector<std::size_t> renumbered(facts_.size(), facts_.size());
  for (std::size_t fact = 0; fact < facts_.size(); ++fact) {
    if (reachable_[fact] == 0 && wanted[fact] == 0) continue;
    renumbered[fact] = problem.facts.size();
    problem.facts.push_back(fact_name(facts_[fact]));
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
  for (const AtomTemplate& atom : numbered_.initials) {
    const auto found = fact_index_.find(key_of(atom, 0));
    if (found != fact_index_.end() && renumbered[found->second] < facts_.size()) {
      problem.initials.set(renumbered[found->second]);
    }
  }
  for (const std::size_t fact : goal_facts) problem.goals.set(renumbered[fact]);
  return problem;
}

Result<Problem> Grounder::run() {
  const Result<void> keys = check_keys();
  if (!keys) return fail(keys);
  for (const AtomTemplate& atom : numbered_.initials) initial_keys_.insert(key_of(atom, 0));
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

Result<Problem> ground(const PlanningTask& task) {
  Result<NumberedTask> numbered = number_task(task);
  if (!numbered) return fail(numbered);
  return Grounder(task, std::move(*numbered)).run();
}

}  // namespace pizarra
