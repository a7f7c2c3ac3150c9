#pragma once

// "There is a plan of so many steps" as clauses: a variable for every fact of every layer and every action of every
// step that the planning graphs, forwards and backwards, leave there.
//
//   StepEncoding encoding(knowledge, steps, solver);
//   if (solver.solve() == 10) encoding.plan();
//
// What an action needs and does not delete it also keeps, which says that nothing in the same step deletes it; so only
// actions that delete the same fact need clauses of their own against each other.

#include <cadical.hpp>

#include "agents/planner/reach/regression_graph.hpp"

namespace pizarra {

// What is known of a problem before a number of steps is tried. Both graphs have levelled off.
struct StepKnowledge {
  const Problem& problem;
  const Exclusions& exclusions;
  const std::vector<FactGroup>& groups;
  const std::vector<Bits>& interferes;
  const PlanningGraph& progression;
  const RegressionGraph& regression;
};

class StepEncoding {
 public:
  // Adds the clauses to the solver, which is new; at least one step.
  StepEncoding(const StepKnowledge& knowledge, std::size_t steps, CaDiCaL::Solver& solver);

  // After the solver has found an assignment.
  std::vector<std::vector<std::size_t>> plan() const;
  std::size_t variables() const { return static_cast<std::size_t>(last_variable_); }

 private:
  using Layer = std::vector<int>;  // a variable for each fact or action; 0: not there
  void number_variables();
  void fix_ends();
  void add_effects(std::size_t step);
  void add_frames(std::size_t step);
  void add_rivals(std::size_t step);
  void add_exclusions(std::size_t layer);
  void clause(std::initializer_list<int> literals);
  void frame(int literal, int otherwise, const std::vector<std::size_t>& actions, const Layer& step);

  const StepKnowledge& known_;
  std::size_t steps_;
  CaDiCaL::Solver& solver_;
  int last_variable_ = 0;
  std::vector<Layer> facts_;    // by layer: steps + 1 of them
  std::vector<Layer> actions_;  // by step
  std::vector<std::vector<std::size_t>> adders_, deleters_;
};

}  // namespace pizarra
