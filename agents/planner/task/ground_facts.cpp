#include "agents/planner/task/ground_facts.hpp"

#include <algorithm>
#include <limits>

namespace pizarra::planner {

namespace {

std::size_t object_of(std::size_t term, const Binding& binding) {
  return term < binding.size() ? binding[term] : term - binding.size();
}

}  // namespace

GroundFacts::GroundFacts(const NumberedTask& task) : task_(task) {
  for (const AtomTemplate& atom : task.initials) initials_.insert(key_of(atom, {}));
  for (const auto& [function, value] : task.values) values_.emplace(key_of(function, {}), value);
}

Result<void> GroundFacts::check() const {
  std::size_t arity = 0;
  for (const NumberedPredicate& predicate : task_.predicates) arity = std::max(arity, predicate.arity);
  Key keys = task_.predicates.size() + 1;
  for (std::size_t i = 0; i < arity; ++i) {
    if (keys > std::numeric_limits<Key>::max() / (task_.objects.size() + 1)) {
      return fail("too-large", "there are too many objects for predicates with so many arguments");
    }
    keys *= task_.objects.size() + 1;
  }
  return {};
}

GroundFacts::Key GroundFacts::key_of(const AtomTemplate& atom, const Binding& binding) const {
  Key key = 0;
  for (const std::size_t term : atom.terms) key = key * task_.objects.size() + object_of(term, binding);
  return key * task_.predicates.size() + atom.predicate;
}

std::size_t GroundFacts::number(const AtomTemplate& atom, const Binding& binding) {
  const auto [found, added] = index_.emplace(key_of(atom, binding), facts_.size());
  if (added) {
    AtomTemplate ground{.predicate = atom.predicate, .terms = {}, .last_parameter = 0};
    for (const std::size_t term : atom.terms) ground.terms.push_back(object_of(term, binding));
    facts_.push_back(std::move(ground));
  }
  return found->second;
}

std::vector<std::size_t> GroundFacts::numbers(const std::vector<AtomTemplate>& atoms, const Binding& binding) {
  std::vector<std::size_t> facts;
  for (const AtomTemplate& atom : atoms) facts.push_back(number(atom, binding));
  std::ranges::sort(facts);
  facts.erase(std::unique(facts.begin(), facts.end()), facts.end());
  return facts;
}

bool GroundFacts::changes(const AtomTemplate& atom) const {
  const NumberedPredicate& predicate = task_.predicates[atom.predicate];
  return predicate.is_complement ? task_.predicates[predicate.complement].changes : predicate.changes;
}

bool GroundFacts::holds_initially(const AtomTemplate& atom, const Binding& binding) const {
  const NumberedPredicate& predicate = task_.predicates[atom.predicate];
  if (!predicate.is_complement) return initials_.contains(key_of(atom, binding));
  AtomTemplate opposite = atom;
  opposite.predicate = predicate.complement;
  return !initials_.contains(key_of(opposite, binding));
}

std::optional<std::int64_t> GroundFacts::value(const AtomTemplate& function, const Binding& binding) const {
  const auto found = values_.find(key_of(function, binding));
  if (found == values_.end()) return std::nullopt;
  return found->second;
}

}  // namespace pizarra::planner
