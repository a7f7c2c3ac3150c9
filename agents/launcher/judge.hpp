#pragma once

// The judge: what a domain's predicates truly are in the simulated world, and whether a goal could be had from there.
//
//   Judge judge(domain);
//   Result<std::vector<Datum>> facts = judge.facts(truth);
//   judge.holds(goal, *facts);
//   Result<bool> possible = judge.plan_exists(goal, truth, *facts);
//
// Names are compared without case: facts come out in small letters.

#include <vector>

#include "agents/launcher/truth.hpp"
#include "lisp/domain.hpp"
#include "lisp/perception.hpp"

namespace pizarra {

class Judge {
 public:
  // Failures: those of the domain's perception section.
  static Result<Judge> make(const Domain& domain);

  // on, on-table, clear, holding and arm-empty as the physics has them, every other predicate by the domain's own
  // perception rules from true positions. Sorted.
  Result<std::vector<Datum>> facts(const Truth& truth) const;
  static bool holds(const std::vector<Datum>& goal, const std::vector<Datum>& facts);
  // The truth's facts, and where a cube leans or lies askew what a person would say of it: it is on what it lies on, or
  // on the table, and where nothing lies on it it can be picked up. Sorted.
  static std::vector<Datum> as_a_person_would_say(const Truth& truth);
  // By breadth-first search over whole states, from what a person would say. A goal with an object that is gone, or
  // below the table, has no plan. Failure: gave-up.
  Result<bool> plan_exists(const std::vector<Datum>& goal, const Truth& truth, const std::vector<Datum>& facts) const;

 private:
  Judge(Domain domain, Perception perception) : domain_(std::move(domain)), perception_(std::move(perception)) {}
  // Those whose predicate the domain has.
  std::vector<Datum> declared(std::vector<Datum> facts) const;
  Domain domain_;
  Perception perception_;
};

}  // namespace pizarra
