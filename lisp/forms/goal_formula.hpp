#pragma once

// The meaning of a goal: facts joined by `and`, `or`, `not`, quantified over the objects of a type, counted.
//
//   (or (on a b) (and (on-table a) (not (on b c))))
//   (forall (<x> OBJECT) (on-table <x>))      (exists (<x> OBJECT) (on <x> a))
//   (at-least 2 (<x> OBJECT) (on-table <x>))  (not (= <x> <y>))
//
// As goals.scm hands them on: variables are `<x>`, since a fact of the board holds no ?variables. A goal is a list of
// such forms, all of them wanted.
//
//   const Result<std::vector<GoalLiterals>> ways = goal_alternatives(goal, {{"a", "OBJECT"}, {"b", "OBJECT"}});
//   const bool reached = goal_holds(goal, beliefs, objects);
//
// A literal is a fact, or (not FACT).

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "lisp/datum.hpp"
#include "lisp/result.hpp"

namespace pizarra::forms {

// Names with their types.
using TypedObjects = std::vector<std::pair<std::string, std::string>>;
// All of which are wanted together.
using GoalLiterals = std::vector<Datum>;

bool literal_holds(const Datum& literal, const std::set<Datum>& facts);

// The ways to have the goal with these objects, each a conjunction, none a part of which is another way; none where it
// contradicts itself. Failure: too-many, beyond most_ways.
inline constexpr std::size_t most_ways = 300;
Result<std::vector<GoalLiterals>> goal_alternatives(const std::vector<Datum>& goal, const TypedObjects& objects);

bool goal_holds(const std::vector<Datum>& goal, const std::set<Datum>& facts, const TypedObjects& objects);

// The parts of the goal that do not hold: its conjuncts, an `or` or a quantifier whole.
std::vector<Datum> unmet_parts(const std::vector<Datum>& goal, const std::set<Datum>& facts,
                               const TypedObjects& objects);

// A part that wants some objects of a type, where there are fewer: the reason why there is no way to have the goal.
struct TooFewObjects {
  Datum part;
  std::string type;
  std::size_t wanted;
  std::size_t there;
};
std::optional<TooFewObjects> too_few_objects(const std::vector<Datum>& goal, const TypedObjects& objects);

// The objects that it names, in their order, each once.
std::vector<std::string> objects_in(const std::vector<Datum>& goal);

// Whether the goal is about all objects of the type, as `forall` and `not exists` are; about some, as `exists` and
// `at-least`; or quantifies over none.
enum class Quantified { none, some, all };
Quantified quantified_over(const std::vector<Datum>& goal, std::string_view type);

// With `<x>` for each variable ?x.
Datum without_variables(const Datum& form);

}  // namespace pizarra::forms
