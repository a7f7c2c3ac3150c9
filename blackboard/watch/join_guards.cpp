#include "blackboard/watch/join_guards.hpp"

#include <algorithm>

#include "blackboard/store/narrowing.hpp"
#include "lisp/pattern.hpp"

namespace pizarra::watch {

namespace {

using Kind = Query::Clause::Kind;

// Of a watch: each takes memory for every value.
constexpr std::size_t most_guarded = 4;

bool has_constant(const Datum& pattern) { return std::ranges::any_of(pattern.items().subspan(1), is_ground); }

// By a variable that is an argument of both.
bool guard(WatchedPattern& pattern, WatchedPattern& guard) {
  const auto arguments = pattern.pattern.items().subspan(1);
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!is_variable(arguments[i]) || arguments[i].is_symbol("?")) continue;
    const std::optional<std::size_t> said = store::argument_of(arguments[i], guard.pattern);
    if (!said) continue;
    guard.is_guard = true;
    pattern.guard = WatchedPattern::Guard{&guard, *said, i, {}};
    return true;
  }
  return false;
}

}  // namespace

void guard_by_joins(const Query& query, std::vector<WatchedPattern>& patterns) {
  std::vector<Kind> kinds;
  for (const Query::Clause& clause : query.clauses) {
    if (clause.kind != Kind::compare) kinds.push_back(clause.kind);
  }
  std::vector<std::size_t> guards;
  std::size_t guarded = 0;
  // A variable of a `not` that nothing before it binds stands for anything.
  const auto find_guard = [&](std::size_t i) {
    const bool found = guarded < most_guarded && std::ranges::any_of(guards, [&](std::size_t other) {
                         return (kinds[i] == Kind::fact || other < i) && guard(patterns[i], patterns[other]);
                       });
    guarded += found ? 1 : 0;
    return found;
  };
  const auto may_guard = [&](std::size_t i) { return kinds[i] == Kind::fact && has_constant(patterns[i].pattern); };
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    if (may_guard(i) && !find_guard(i)) guards.push_back(i);
  }
  for (std::size_t i = 0; i < patterns.size(); ++i) {
    if (!may_guard(i)) find_guard(i);
  }
}

void allow_what_stands(WatchedPattern& pattern, const store::Tables& tables) {
  if (!pattern.guard) return;
  const Datum& guarding = pattern.guard->by->pattern;
  // Others may have to be looked at for them.
  std::size_t left = 4 * WatchedPattern::most_allowed;
  tables.find(guarding.head())->second.visit(guarding, [&](const Fact& fact) {
    if (pattern.guard->by->may_fit(fact.datum)) ++pattern.guard->allowed[pattern.guard->value_of(fact.datum)];
    if (--left == 0 || pattern.guard->allowed.size() > WatchedPattern::most_allowed) pattern.guard.reset();
    return pattern.guard.has_value();
  });
}

}  // namespace pizarra::watch
