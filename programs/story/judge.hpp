#pragma once

// The judge: what a domain's predicates truly are in the simulated world, and whether a goal could be had from there.
//
//   Result<Judge> judge = Judge::make(domain, 60);
//   Result<std::vector<Datum>> facts = judge->facts(truth);
//   Judge::holds(goal, *facts);
//   Result<bool> possible = judge->plan_exists(goal, truth);
//
// Names are compared without case: facts come out in small letters.

#include <string>
#include <vector>

#include "lisp/forms/domain.hpp"
#include "lisp/forms/goal_formula.hpp"
#include "lisp/forms/perception.hpp"
#include "programs/story/world_state.hpp"

namespace pizarra::story {

// After so long, a cube that was put down or fell stands still.
inline constexpr Duration settling_time = 1500ms;

class Judge {
 public:
  // Of a cell with cubes of that size, but for those that have an edge of their own. Failures: those of the domain's
  // perception section.
  static Result<Judge> make(const forms::Domain& domain, double cube_mm, const forms::EdgesMm& edges_mm = {});

  double edge_mm(const std::string& name) const;

  // The facts that the domain's own perception rules find where everything that stands firmly or is held is seen truly.
  // A cube that leans, falls or is carried by a hand is in no state that a predicate names, nor is what stands on it.
  // Sorted.
  Result<std::vector<Datum>> facts(const WorldState& truth) const;
  static bool holds(const std::vector<Datum>& goal, const std::vector<Datum>& facts);
  // Whether what the goal wants in the end is so: its last stage, quantified over the cubes that are there.
  Result<bool> shows(const std::vector<Datum>& goal, const WorldState& truth) const;
  // As facts(), each cube that leans or lies askew taken to stand squarely on what it lies on, or on the table: what a
  // person would say of it. Sorted.
  Result<std::vector<Datum>> as_a_person_would_say(const WorldState& truth) const;
  // By breadth-first search over whole states, from what a person would say. A goal with an object that is gone, or
  // below the table, has no plan. Failure: gave-up.
  Result<bool> plan_exists(const std::vector<Datum>& goal, const WorldState& truth) const;

 private:
  Judge(forms::Domain domain, forms::Perception perception, double cube_mm, forms::EdgesMm edges_mm)
      : domain_(std::move(domain)),
        perception_(std::move(perception)),
        cube_mm_(cube_mm),
        edges_mm_(std::move(edges_mm)) {}
  std::vector<Datum> measured(const WorldState& truth) const;
  std::string support_of(const WorldState& truth, const WorldState::Cube& loose) const;
  WorldState squared(WorldState truth) const;
  forms::TypedObjects objects(const WorldState& truth) const;
  forms::Domain domain_;
  forms::Perception perception_;
  double cube_mm_;
  forms::EdgesMm edges_mm_;  // by names in small letters
};

}  // namespace pizarra::story
