#include "agents/planner/optimal/sat_search.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/planner/graphplan/graphplan.hpp"
#include "agents/planner/task/idle_actions.hpp"

namespace pizarra {

namespace {

constexpr std::size_t nodes_a_conflict = 100;
// The backward search is asked after so many numbers of steps, then twice as many, with as many nodes for each.
constexpr std::size_t steps_before_proof = 8;
constexpr std::size_t proof_nodes_a_step = 4000;
constexpr std::size_t bytes_a_variable = 1500;  // with its clauses, as measured

class Stop : public CaDiCaL::Terminator {
 public:
  explicit Stop(const std::function<bool()>& cancelled) : cancelled_(cancelled) {}
  bool terminate() override { return seen_ = seen_ || cancelled_(); }

 private:
  const std::function<bool()>& cancelled_;
  bool seen_ = false;
};

class ConflictCount : public CaDiCaL::Learner {
 public:
  bool learning(int) override {
    ++count_;
    return false;
  }
  void learn(int) override {}
  std::size_t count() const { return count_; }

 private:
  std::size_t count_ = 0;
};

}  // namespace

SatSearch::SatSearch(const Problem& problem, const Exclusions& exclusions, const std::vector<Bits>& interferes,
                     RegressionGraph& regression, const Budget& budget, const std::function<bool()>& cancelled)
    : problem_(problem),
      exclusions_(exclusions),
      interferes_(interferes),
      regression_(regression),
      budget_(budget),
      cancelled_(cancelled),
      progression_(problem) {}

// False: ended before, as the outcome says.
bool SatSearch::build_graphs(Outcome& outcome) {
  while (!progression_.levelled_off() || !regression_.levelled_off()) {
    if (cancelled_()) {
      outcome.kind = Outcome::Kind::cancelled;
      return false;
    }
    if (progression_.bytes() + progression_.bytes_per_level() > budget_.bytes) {
      outcome.spent = fmt::format("{} MB of memory", budget_.bytes >> 20);
      return false;
    }
    progression_.expand();
    regression_.expand();
  }
  return true;
}

// Whether the graphs let the goals be reached in so many steps.
bool SatSearch::possible(std::size_t steps) const {
  const FactLevel& last = progression_.fact_level(steps);
  bool reached = problem_.goals.subset_of(last.present);
  problem_.goals.for_each([&](std::size_t goal) { reached = reached && !last.mutex[goal].intersects(problem_.goals); });
  return reached && regression_.allows(problem_.initials, steps);
}

bool SatSearch::try_steps(const StepKnowledge& knowledge, std::size_t steps, Outcome& outcome) {
  CaDiCaL::Solver solver;
  Stop stop(cancelled_);
  ConflictCount conflicts;
  solver.set("quiet", 1);
  solver.connect_terminator(&stop);
  solver.connect_learner(&conflicts);
  const StepEncoding encoding(knowledge, steps, solver);
  if (encoding.variables() * bytes_a_variable > budget_.bytes) {
    outcome.spent = fmt::format("{} MB of memory", budget_.bytes >> 20);
    return true;
  }
  const std::size_t left = (budget_.nodes - std::min(nodes_, budget_.nodes)) / nodes_a_conflict;
  solver.limit("conflicts", static_cast<int>(std::min<std::size_t>(left, INT32_MAX)));
  const int answer = solver.solve();
  nodes_ += conflicts.count() * nodes_a_conflict;
  if (answer == 20) return false;
  if (answer == 10) {
    outcome.kind = Outcome::Kind::plan;
    outcome.steps = without_idle_actions(problem_, encoding.plan());
  } else if (cancelled_()) {
    outcome.kind = Outcome::Kind::cancelled;
  } else {
    outcome.spent = fmt::format("{} search nodes", budget_.nodes);
  }
  return true;
}

bool SatSearch::prove_none(Outcome& outcome) {
  Budget budget = budget_;
  budget.nodes = std::min(steps_before_proof * proof_nodes_a_step, budget_.nodes - std::min(nodes_, budget_.nodes));
  Outcome proof = Graphplan().solve(problem_, budget, cancelled_);
  nodes_ += proof.nodes;
  if (proof.kind != Outcome::Kind::none) return false;
  outcome.kind = Outcome::Kind::none;
  outcome.culprits = std::move(proof.culprits);
  return true;
}

Outcome SatSearch::run(std::size_t at_least) {
  Outcome outcome{.kind = Outcome::Kind::gave_up, .steps = {}, .culprits = {}, .spent = {}, .nodes = 0};
  if (!build_graphs(outcome)) return outcome;
  const std::size_t levelled_off = std::max(progression_.size(), regression_.size());
  const std::vector<FactGroup> groups = exclusion_groups(exclusions_);
  const StepKnowledge knowledge{problem_, exclusions_, groups, interferes_, progression_, regression_};
  std::size_t until_proof = steps_before_proof;
  std::size_t tried = 0;
  bool ended = false;
  for (std::size_t steps = at_least; steps <= budget_.levels && !ended; ++steps) {
    if (!possible(steps)) {
      if (steps < levelled_off) continue;
      outcome.kind = Outcome::Kind::none;
      problem_.goals.for_each([&](std::size_t goal) { outcome.culprits.push_back(goal); });
      break;
    }
    ended = try_steps(knowledge, steps, outcome);
    if (!ended && ++tried == until_proof) {
      ended = prove_none(outcome);
      until_proof *= 2;
    }
  }
  if (!ended && outcome.kind == Outcome::Kind::gave_up) outcome.spent = fmt::format("{} levels", budget_.levels);
  outcome.nodes = nodes_;
  return outcome;
}

}  // namespace pizarra
