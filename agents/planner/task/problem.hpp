#pragma once

// A grounded STRIPS problem and the interface of the engines that solve it.
//
//   const Result<Problem> problem = ground(task);
//   Graphplan engine;
//   const Outcome outcome = engine.solve(*problem, Budget{}, [] { return false; });
//   if (outcome.kind == Outcome::Kind::plan) PlanSteps steps = steps_of(*problem, outcome.steps);
//
// Engines are deterministic: the same problem and budget give the same outcome, unless cancelled.

#include <functional>

#include "agents/planner/task/bits.hpp"
#include "agents/planner/task/planning_task.hpp"

namespace pizarra::planner {

struct GroundAction {
  Datum name;  // (STACK circle triangle)
  // Indices of facts, ascending, none twice; `deletes` and `adds` have none in common.
  std::vector<std::size_t> preconditions;
  std::vector<std::size_t> adds;
  std::vector<std::size_t> deletes;
  std::int64_t cost = 1;
};

// Where the task asks that a fact be absent, `(not FACT)` is a fact of the problem too: it holds when the other does
// not.
struct Problem {
  std::vector<Datum> facts;
  std::vector<GroundAction> actions;
  Bits initials;
  Bits goals;
};

// Whether one of the two deletes what the other needs or adds: they then cannot share a step.
bool interfere(const GroundAction& a, const GroundAction& b);
// For every action, those it interferes with.
std::vector<Bits> interference(const Problem& problem);

void apply(const GroundAction& action, Bits& state);
// The state after an action.
Bits after(const Bits& state, const GroundAction& action);
bool applicable(const GroundAction& action, const Bits& state);

// The work an engine may do before it gives up: counted, never timed.
struct Budget {
  std::size_t nodes = 4'000'000;
  std::size_t levels = 250;
  std::size_t bytes = 256 << 20;
};

struct Outcome {
  enum class Kind : std::uint8_t {
    plan,      // `steps` reaches the goals
    none,      // proved: no plan of any length does
    gave_up,   // the budget was spent first
    cancelled  // by the caller
  };
  Kind kind = Kind::gave_up;
  std::vector<std::vector<std::size_t>> steps = {};  // indices of actions, ascending within a step
  // For `none`: goals that cannot all hold together, as few as the engine found: one that can never hold, two that
  // exclude each other, or more. For `gave_up`: empty.
  std::vector<std::size_t> culprits = {};
  std::string spent = {};        // for `gave_up`: which bound, for people
  std::size_t nodes = 0;         // work done
  std::string_view engine = {};  // which search answered, where there are several; a literal
  bool shortest = false;         // a plan's: proved that none has fewer steps, nor fewer actions
  bool out_of_memory = false;    // a plan's: with more of it the plan might be shorter
};

class PlanEngine {
 public:
  virtual ~PlanEngine() = default;
  virtual Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) = 0;
};

PlanSteps steps_of(const Problem& problem, const std::vector<std::vector<std::size_t>>& steps);

}  // namespace pizarra::planner
