#include "agents/planner/optimal/step_search.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <ranges>
#include <unordered_map>

#include "agents/planner/optimal/interchangeable.hpp"
#include "agents/planner/task/idle_actions.hpp"

namespace pizarra::planner {

namespace {

constexpr std::size_t max_steps_a_state = 4096;
constexpr std::size_t max_steps_going_again = 1 << 20;
constexpr std::size_t max_interfering = 4000;  // their interference takes a bit a pair

using Step = std::vector<std::size_t>;

class Search {
 public:
  Search(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled)
      : problem_(problem),
        budget_(budget),
        cancelled_(cancelled),
        alike_(problem),
        interferes_(interference(problem)) {}

  Outcome run() {
    reach(problem_.initials, 0);
    std::size_t index = 0;
    for (; index < reached_.size() && !goal_ && stop_ == Outcome::Kind::none; ++index) {
      const Bits state = reached_[index].state;
      each_step(state, [&](const Bits& next, const Step&) {
        reach(next, index);
        return goal_.has_value();
      });
      if (cancelled_()) stop_ = Outcome::Kind::cancelled;
      const std::size_t bytes = reached_.size() * (2 * problem_.initials.words().size() * 8 + 150);
      if (steps_seen_ > budget_.nodes || bytes > budget_.bytes) stop_ = Outcome::Kind::gave_up;
    }
    std::vector<Step> steps;
    if (goal_) steps = without_idle_actions(problem_, steps_to(*goal_));
    Outcome outcome{.kind = goal_ && stop_ == Outcome::Kind::none ? Outcome::Kind::plan : stop_,
                    .steps = std::move(steps),
                    .spent = fmt::format("{} steps from {} states", steps_seen_, index),
                    .nodes = steps_seen_};
    if (outcome.kind == Outcome::Kind::none) outcome.culprits = problem_.goals.members();
    return outcome;
  }

 private:
  struct Reached {
    Bits state;  // with the alike objects sorted
    std::size_t from;
  };

  void reach(Bits state, std::size_t from) {
    alike_.sort(state);
    if (!index_.emplace(state, reached_.size()).second) return;
    if (problem_.goals.subset_of(state)) goal_ = reached_.size();
    reached_.push_back({std::move(state), from});
  }

  // Visits what every set of actions that can share a step leads to, until the visitor has enough.
  template <class Visit>
  void each_step(const Bits& state, Visit visit) {
    Bits open(problem_.actions.size());
    for (std::size_t i = 0; i < problem_.actions.size(); ++i) {
      if (applicable(problem_.actions[i], state)) open.set(i);
    }
    Step step;
    std::size_t here = 0;
    extend(state, open, step, here, visit);
    if (here > max_steps_a_state_) stop_ = Outcome::Kind::gave_up;
  }

  template <class Visit>
  bool extend(const Bits& state, const Bits& open, Step& step, std::size_t& here, Visit& visit) {
    bool enough = false;
    Bits left = open;
    open.for_each([&](std::size_t action) {
      if (enough) return;
      if (++here > max_steps_a_state_) {
        enough = true;
        return;
      }
      ++steps_seen_;
      left.reset(action);
      const Bits next = after(state, problem_.actions[action]);
      step.push_back(action);
      enough = visit(next, step);
      Bits beside = left;
      beside -= interferes_[action];
      if (!enough && beside.any()) enough = extend(next, beside, step, here, visit);
      step.pop_back();
    });
    return enough;
  }

  // Goes the way again, as the objects really are.
  std::vector<Step> steps_to(std::size_t index) {
    max_steps_a_state_ = max_steps_going_again;
    std::vector<std::size_t> way;
    for (; index != 0; index = reached_[index].from) way.push_back(index);
    std::vector<Step> steps;
    Bits state = problem_.initials;
    for (const std::size_t next_index : way | std::views::reverse) {
      Bits next_state;
      each_step(state, [&](const Bits& next, const Step& step) {
        Bits sorted = next;
        alike_.sort(sorted);
        if (sorted != reached_[next_index].state) return false;
        next_state = next;
        steps.push_back(step);
        return true;
      });
      state = std::move(next_state);
    }
    return steps;
  }

  const Problem& problem_;
  const Budget& budget_;
  const std::function<bool()>& cancelled_;
  Interchangeable alike_;
  std::vector<Bits> interferes_;
  std::vector<Reached> reached_;
  std::unordered_map<Bits, std::size_t, HashBits> index_;  // looked up only
  std::optional<std::size_t> goal_;
  Outcome::Kind stop_ = Outcome::Kind::none;
  std::size_t max_steps_a_state_ = max_steps_a_state;
  std::size_t steps_seen_ = 0;
};

}  // namespace

Outcome StepSearch::solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) {
  if (problem.goals.subset_of(problem.initials)) {
    return {.kind = Outcome::Kind::plan};
  }
  if (problem.actions.size() > max_interfering) {
    return {.kind = Outcome::Kind::gave_up, .spent = fmt::format("{} actions", max_interfering)};
  }
  return Search(problem, budget, cancelled).run();
}

}  // namespace pizarra::planner
