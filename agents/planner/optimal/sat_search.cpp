#include "agents/planner/optimal/sat_search.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "agents/planner/graphplan/graphplan.hpp"
#include "agents/planner/optimal/step_encoding.hpp"
#include "agents/planner/task/idle_actions.hpp"

namespace pizarra::planner {

namespace {

constexpr std::size_t nodes_a_conflict = 100;
// The backward search is asked after so many numbers of steps, then twice as many, with as many nodes for each.
constexpr std::size_t steps_before_proof = 8;
constexpr std::size_t proof_nodes_a_step = 4000;
constexpr std::size_t bytes_a_literal = 100;  // of the clauses given, with what is learned: 40 to 120, as measured

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

std::string megabytes(const Budget& budget) { return fmt::format("{} MB of memory", budget.bytes >> 20); }

}  // namespace

struct SatSearch::Solver {
  Solver(const Problem& problem, const Exclusions& exclusions, RegressionGraph& regression)
      : encoding(problem, exclusions, regression, cadical) {
    cadical.set("quiet", 1);
  }
  std::size_t bytes() const { return encoding.size() * bytes_a_literal; }

  CaDiCaL::Solver cadical;
  StepEncoding encoding;
};

SatSearch::SatSearch(const Problem& problem, const Exclusions& exclusions)
    : problem_(problem),
      exclusions_(exclusions),
      interferes_(interference(problem)),
      regression_(problem, exclusions, interferes_) {}

SatSearch::~SatSearch() = default;

bool SatSearch::grow_graph(Run& run, std::size_t steps) {
  while (regression_.size() <= steps && !regression_.levelled_off()) {
    if (run.cancelled()) {
      run.outcome.kind = Outcome::Kind::cancelled;
      return true;
    }
    regression_.expand();
  }
  return false;
}

bool SatSearch::try_steps(Run& run, std::size_t steps) {
  solver_->encoding.add_steps(steps);
  if (solver_->bytes() > run.budget.bytes) {
    run.outcome.spent = megabytes(run.budget);
    return true;
  }
  CaDiCaL::Solver& cadical = solver_->cadical;
  Stop stop(run.cancelled);
  ConflictCount conflicts;
  cadical.connect_terminator(&stop);
  cadical.connect_learner(&conflicts);
  const int begins = solver_->encoding.begin_at(problem_.initials, steps);
  cadical.assume(begins);
  cadical.limit("conflicts", static_cast<int>(std::min<std::size_t>(run.nodes_left() / nodes_a_conflict, INT32_MAX)));
  const int answer = cadical.solve();
  cadical.disconnect_learner();
  cadical.disconnect_terminator();
  run.outcome.nodes += conflicts.count() * nodes_a_conflict;
  if (answer == 10) {
    run.outcome.kind = Outcome::Kind::plan;
    run.outcome.steps = without_idle_actions(problem_, solver_->encoding.plan(steps));
  } else if (answer != 20 && run.cancelled()) {
    run.outcome.kind = Outcome::Kind::cancelled;
  } else if (answer != 20) {
    run.outcome.spent = fmt::format("{} search nodes", run.budget.nodes);
  }
  solver_->encoding.retire(begins);
  return answer != 20;
}

bool SatSearch::prove_none(Run& run) {
  Budget budget = run.budget;
  budget.nodes = std::min(steps_before_proof * proof_nodes_a_step, run.nodes_left());
  Outcome proof = Graphplan().solve(problem_, budget, run.cancelled);
  run.outcome.nodes += proof.nodes;
  if (proof.kind != Outcome::Kind::none) return false;
  run.outcome.kind = Outcome::Kind::none;
  run.outcome.culprits = std::move(proof.culprits);
  return true;
}

Outcome SatSearch::run(std::size_t at_least, const Budget& budget, const std::function<bool()>& cancelled) {
  Run run{budget, cancelled, {.kind = Outcome::Kind::gave_up}};
  if (solver_ && solver_->bytes() > budget.bytes / 2) solver_.reset();
  if (!solver_) solver_ = std::make_unique<Solver>(problem_, exclusions_, regression_);
  std::size_t until_proof = steps_before_proof;
  std::size_t tried = 0;
  for (std::size_t steps = at_least; steps <= budget.levels; ++steps) {
    if (grow_graph(run, steps)) return run.outcome;
    const bool levelled_off = steps >= regression_.size();
    if (!regression_.allows(problem_.initials, steps)) {
      if (!levelled_off) continue;
      run.outcome.kind = Outcome::Kind::none;
      run.outcome.culprits = problem_.goals.members();
      return run.outcome;
    }
    if (try_steps(run, steps)) return run.outcome;
    if (!levelled_off || ++tried != until_proof) continue;
    if (prove_none(run)) return run.outcome;
    until_proof *= 2;
  }
  run.outcome.spent = fmt::format("{} levels", budget.levels);
  return run.outcome;
}

}  // namespace pizarra::planner
