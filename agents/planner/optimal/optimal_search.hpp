#pragma once

// The shortest plans of one problem, from wherever it begins, by whichever search suits the problem:
//
//   guided     every action needs one resource: A* under the landmark bound (blocks world, with hundreds of facts)
//   stepwise   few states, however long the plan: breadth-first over parallel steps (hanoi, gripper)
//   sat        everything else: satisfiability, one number of steps after another (logistics)
//
//   OptimalSearch search(problem);
//   Outcome outcome = search.run(budget, cancelled);
//   problem.initials = now;
//   if (search.covers(now)) outcome = search.run(budget, cancelled);      // with what was learned before
//
// Outcome::engine says which of them answered. A plan has the fewest parallel steps there can be; `none` is proved.

#include <optional>

#include "agents/planner/guided/guided_search.hpp"
#include "agents/planner/optimal/sat_search.hpp"

namespace pizarra::planner {

class OptimalSearch {
 public:
  // The problem outlives the search; only its initial facts may change meanwhile.
  explicit OptimalSearch(const Problem& problem);
  OptimalSearch(const OptimalSearch&) = delete;
  OptimalSearch& operator=(const OptimalSearch&) = delete;

  // Whether what was found out about the problem holds where it begins with these facts.
  bool covers(const Bits& initials) const { return exclusions_ && exclusions_->allow(initials); }
  Outcome run(const Budget& budget, const std::function<bool()>& cancelled);

 private:
  bool prepare(const std::function<bool()>& cancelled);
  void forget();
  Outcome attempt(const Budget& budget, const std::function<bool()>& cancelled);

  const Problem& problem_;
  // Made when first needed.
  std::optional<Exclusions> exclusions_;
  bool prepared_ = false;
  std::optional<DeadEnds> dead_ends_;  // none: not looked for
  std::optional<LandmarkBound> bound_;
  std::optional<Nearness> nearness_;
  std::optional<GuidedSearch> guided_;
  std::optional<SatSearch> sat_;
};

// The same for one plan alone.
class OptimalPlanner : public PlanEngine {
 public:
  Outcome solve(const Problem& problem, const Budget& budget, const std::function<bool()>& cancelled) override {
    return OptimalSearch(problem).run(budget, cancelled);
  }
};

}  // namespace pizarra::planner
