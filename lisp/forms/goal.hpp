#pragma once

// Goals as a person types them, checked against a domain: facts, what joins them (goal_formula.hpp), and around a whole
// goal its stages (then GOAL GOAL ...), or that it is kept (keep GOAL ...), with (wait SECONDS) for missing objects
// (lisp/modules/pizarra/goals.scm).
//
//   auto goal = read_goal(domain, "(and (on circle Triangle) (on triangle square))", {{"circle", "OBJECT"}, ...});
//   // (on circle triangle), (on triangle square)
//
// Names are compared without regard to case and come out as they are known; a string names an object as a symbol does.
// Repeated facts come out once.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "lisp/forms/domain.hpp"

namespace pizarra::forms {

// `objects_with_types` are what was seen; the domain's own objects are known besides. Failures, all in one report with
// carets: the reader's, malformed, unknown-predicate, unknown-object, unknown-type, wrong-arity, wrong-type,
// not-ground, contradictory (a fact both wanted and not wanted), too-many (500). Whether a plan exists is the planner's
// to say.
Result<std::vector<Datum>> read_goal(const Domain& domain, std::string_view text,
                                     const std::vector<std::pair<std::string, std::string>>& objects_with_types);

// The same of facts that came as data, as in a request. Failures are about the text that they make, one on a line.
Result<std::vector<Datum>> goal_from_data(const Domain& domain, const std::vector<Datum>& facts,
                                          const std::vector<std::pair<std::string, std::string>>& objects_with_types);

// The same while nothing was seen yet: any name may be an object, and comes out as it was typed.
Result<std::vector<Datum>> check_goal(const Domain& domain, std::string_view text);

// A refusal with the place in the goal's text of the first fact or object that its subject names; without one where it
// names none of them. That there is no plan is about the whole goal, when it names none.
Failure at_its_goal(Failure refusal, std::string_view text);

}  // namespace pizarra::forms
