#pragma once

// "From this state the goals can be reached in so many steps" as clauses: a variable for every fact of every layer and
// every action of every step that the regression graph leaves there. Layers are numbered from the goals back, layer 3
// being that with three steps to go; so what stands for one number of steps stands for a larger one and for every other
// state, too, and so does all that a solver learns from it.
//
//   StepEncoding encoding(problem, exclusions, regression, solver);
//   encoding.add_steps(5);
//   const int begins = encoding.begin_at(state, 5);
//   solver.assume(begins);
//   if (solver.solve() == 10) encoding.plan(5);
//   encoding.retire(begins);                          // and begin elsewhere
//
// An action keeps the facts that it needs and does not delete. Keeping says that nothing in the same step deletes the
// fact; so only actions that delete the same fact need clauses of their own against each other.

#include <cadical.hpp>
#include <utility>

#include "agents/planner/reach/regression_graph.hpp"

namespace pizarra::planner {

class StepEncoding {
 public:
  // The arguments outlive it; the solver is new. Every state respects the exclusions.
  StepEncoding(const Problem& problem, const Exclusions& exclusions, RegressionGraph& regression,
               CaDiCaL::Solver& solver);

  // Adds what is missing of the clauses for so many steps.
  void add_steps(std::size_t steps);
  // A literal that says: the state holds with so many steps to go. The regression graph allows that.
  int begin_at(const Bits& state, std::size_t steps);
  void retire(int begins) { clause({-begins}); }

  // After the solver has found an assignment under begin_at(state, steps).
  std::vector<std::vector<std::size_t>> plan(std::size_t steps) const;
  // Literals in all clauses so far.
  std::size_t size() const { return size_; }

 private:
  using Layer = std::vector<int>;  // a variable for each fact or action; 0: not there
  void find_rivals();
  void add_layer();
  void add_actions();
  void add_effects();
  void add_frames();
  void add_rivals();
  void add_exclusions();
  void clause(std::initializer_list<int> literals);
  void frame(int literal, int otherwise, const std::vector<std::size_t>& actions);

  const Problem& problem_;
  const Exclusions& exclusions_;
  RegressionGraph& regression_;
  CaDiCaL::Solver& solver_;
  const std::vector<FactGroup> groups_;
  std::vector<std::vector<std::size_t>> adders_, deleters_;
  std::vector<std::pair<std::size_t, std::size_t>> rivals_;  // that nothing else keeps out of one step
  int last_variable_ = 0;
  std::size_t size_ = 0;
  std::vector<Layer> facts_;    // by steps to go
  std::vector<Layer> actions_;  // that lead from layer i + 1 to layer i
};

}  // namespace pizarra::planner
