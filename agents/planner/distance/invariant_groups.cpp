#include "agents/planner/distance/invariant_groups.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace pizarra::planner {

namespace {

constexpr std::size_t max_guesses = 300;
constexpr ActionIndex actions_between_looks = 4096;

struct Named {
  std::uint32_t predicate = 0;
  std::vector<std::uint32_t> arguments;
};

// One predicate of a guess: where in its arguments the group's objects stand; at most one argument is left over.
struct Part {
  std::uint32_t predicate = 0;
  std::vector<std::uint32_t> positions;
  auto operator<=>(const Part&) const = default;
};
using Guess = std::vector<Part>;         // ascending, every predicate once
using Key = std::vector<std::uint32_t>;  // the objects of one group

class Finder {
 public:
  Finder(const Problem& problem, const CompactProblem& compact, const std::function<bool()>& cancelled)
      : compact_(compact), cancelled_(cancelled) {
    name_facts(problem);
  }

  std::vector<std::vector<FactIndex>> run() {
    for (const auto& [predicate, arity] : arities_) guess_alone(predicate, arity);
    for (std::size_t i = 0; i < guesses_.size() && i < max_guesses && !cancelled_(); ++i) {
      const Guess guess = guesses_[i];
      if (proved(guess)) keep_groups(guess);
    }
    return std::move(groups_);
  }

 private:
  void name_facts(const Problem& problem) {
    std::map<Datum, std::uint32_t> numbers;
    const auto number = [&](const Datum& name) {
      return numbers.emplace(name, static_cast<std::uint32_t>(numbers.size())).first->second;
    };
    for (const Datum& fact : problem.facts) {
      Named named{number(fact[0]), {}};
      for (const Datum& argument : fact.items().subspan(1)) named.arguments.push_back(number(argument));
      arities_[named.predicate] = named.arguments.size();
      named_.push_back(std::move(named));
    }
  }

  void guess_alone(std::uint32_t predicate, std::size_t arity) {
    for (std::size_t left_out = 0; left_out <= arity; ++left_out) {
      Part part{predicate, {}};
      for (std::uint32_t i = 0; i < arity; ++i) {
        if (i != left_out) part.positions.push_back(i);
      }
      guess({part});
    }
  }

  void guess(Guess parts) {
    std::ranges::sort(parts);
    if (guessed_.insert(parts).second) guesses_.push_back(std::move(parts));
  }

  const Part* part_of(const Guess& guess, FactIndex fact) const {
    const auto found = std::ranges::find(guess, named_[fact].predicate, &Part::predicate);
    return found == guess.end() ? nullptr : &*found;
  }

  Key key_of(const Part& part, FactIndex fact) const {
    Key key;
    for (const std::uint32_t position : part.positions) key.push_back(named_[fact].arguments[position]);
    return key;
  }

  bool in_group(const Guess& guess, const Key& key, FactIndex fact) const {
    const Part* part = part_of(guess, fact);
    if (part == nullptr) return false;
    for (std::size_t i = 0; i < key.size(); ++i) {
      if (named_[fact].arguments[part->positions[i]] != key[i]) return false;
    }
    return true;
  }

  bool proved(const Guess& guess) {
    for (ActionIndex action = 0; action < compact_.actions(); ++action) {
      if (action % actions_between_looks == 0 && cancelled_()) return false;
      for (const FactIndex fact : compact_.adds(action)) {
        const Part* part = part_of(guess, fact);
        if (part == nullptr || needs(action, fact)) continue;
        const Key key = key_of(*part, fact);
        if (balanced(guess, key, action)) continue;
        return false;
      }
    }
    return true;
  }

  bool needs(ActionIndex action, FactIndex fact) const {
    return std::ranges::binary_search(compact_.preconditions(action), fact);
  }

  // Whether the action brings into the group no more than it takes from it. Where it takes nothing, what it takes
  // elsewhere makes further guesses.
  bool balanced(const Guess& old, const Key& key, ActionIndex action) {
    const auto brought = std::ranges::count_if(
        compact_.adds(action), [&](FactIndex fact) { return in_group(old, key, fact) && !needs(action, fact); });
    const auto taken = std::ranges::count_if(
        compact_.deletes(action), [&](FactIndex fact) { return in_group(old, key, fact) && needs(action, fact); });
    if (brought <= taken) return true;
    if (brought == 1) {
      for (const FactIndex fact : compact_.deletes(action)) {
        if (needs(action, fact) && part_of(old, fact) == nullptr) extend(old, key, fact);
      }
    }
    return false;
  }

  void extend(const Guess& old, const Key& key, FactIndex fact) {
    const std::vector<std::uint32_t>& arguments = named_[fact].arguments;
    if (arguments.size() > key.size() + 1) return;
    Part part{named_[fact].predicate, {}};
    for (const std::uint32_t object : key) {
      const auto found = std::ranges::find(arguments, object);
      if (found == arguments.end()) return;
      part.positions.push_back(static_cast<std::uint32_t>(found - arguments.begin()));
    }
    Guess more = old;
    more.push_back(std::move(part));
    guess(std::move(more));
  }

  void keep_groups(const Guess& guess) {
    std::map<Key, std::vector<FactIndex>> by_key;
    for (FactIndex fact = 0; fact < named_.size(); ++fact) {
      if (const Part* part = part_of(guess, fact)) by_key[key_of(*part, fact)].push_back(fact);
    }
    for (auto& [key, facts] : by_key) {
      const auto initially =
          std::ranges::count_if(facts, [&](FactIndex fact) { return compact_.initials().test(fact); });
      if (facts.size() > 1 && initially <= 1) groups_.push_back(std::move(facts));
    }
  }

  const CompactProblem& compact_;
  const std::function<bool()>& cancelled_;
  std::vector<Named> named_;
  std::map<std::uint32_t, std::size_t> arities_;
  std::vector<Guess> guesses_;
  std::set<Guess> guessed_;
  std::vector<std::vector<FactIndex>> groups_;
};

}  // namespace

InvariantGroups::InvariantGroups(const Problem& problem, const CompactProblem& compact,
                                 const std::function<bool()>& cancelled)
    : groups_(Finder(problem, compact, cancelled).run()) {
  Rows rows;
  for (const std::vector<FactIndex>& group : groups_) rows.add(group);
  groups_of_ = transposed(rows, compact.facts());
}

bool InvariantGroups::hold_in(const Bits& state) const {
  return std::ranges::all_of(groups_, [&](const std::vector<FactIndex>& group) {
    return std::ranges::count_if(group, [&](FactIndex fact) { return state.test(fact); }) <= 1;
  });
}

bool InvariantGroups::exclude(FactIndex a, FactIndex b) const {
  const std::span<const std::uint32_t> of_a = groups_of_[a], of_b = groups_of_[b];
  auto i = of_a.begin();
  auto j = of_b.begin();
  while (i != of_a.end() && j != of_b.end()) {
    if (*i == *j) return true;
    *i < *j ? ++i : ++j;
  }
  return false;
}

}  // namespace pizarra::planner
