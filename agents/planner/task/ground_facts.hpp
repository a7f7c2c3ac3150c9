#pragma once

// The ground facts of a numbered task, each with a number from when it is first asked for.
//
//   GroundFacts facts(numbered);
//   const Result<void> fits = facts.check();
//   const std::size_t fact = facts.number(atom, {2, 0});    // its parameters are the objects 2 and 0
//   facts.atom(fact); facts.holds_initially(facts.atom(fact), {});

#include <optional>
#include <unordered_map>
#include <unordered_set>

#include "agents/planner/task/numbered_task.hpp"

namespace pizarra::planner {

// The object of each parameter, by its index.
using Binding = std::vector<std::size_t>;

class GroundFacts {
 public:
  // The task outlives the table.
  explicit GroundFacts(const NumberedTask& task);
  // Whether every fact can be told from every other. Failure: too-large.
  Result<void> check() const;

  std::size_t number(const AtomTemplate& atom, const Binding& binding);
  // Ascending, none twice.
  std::vector<std::size_t> numbers(const std::vector<AtomTemplate>& atoms, const Binding& binding);
  std::size_t size() const { return facts_.size(); }
  // Ground: its terms are objects.
  const AtomTemplate& atom(std::size_t fact) const { return facts_[fact]; }

  bool changes(const AtomTemplate& atom) const;
  // Of the initial facts and their complements.
  bool holds_initially(const AtomTemplate& atom, const Binding& binding) const;
  // Of a function.
  std::optional<std::int64_t> value(const AtomTemplate& function, const Binding& binding) const;

 private:
  // Numbers a fact without building its Datum: mixed radix over objects, behind the predicate.
  using Key = std::uint64_t;
  Key key_of(const AtomTemplate& atom, const Binding& binding) const;

  const NumberedTask& task_;
  std::unordered_set<Key> initials_;  // looked up only, as the next two
  std::unordered_map<Key, std::int64_t> values_;
  std::unordered_map<Key, std::size_t> index_;
  std::vector<AtomTemplate> facts_;
};

}  // namespace pizarra::planner
