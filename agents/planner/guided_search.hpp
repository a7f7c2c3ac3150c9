#pragma once

// A* for problems in which every action needs one and the same resource, so that no step has more than one: under the
// landmark bound, which is often exact there.
//
//   GuidedSearch search(problem, exclusions, dead_ends, bound, budget, cancelled);
//   Outcome outcome = search.run();
//
// Budget::nodes counts states for which the bound was asked.

#include <unordered_map>

#include "agents/planner/dead_ends.hpp"
#include "agents/planner/landmark_bound.hpp"

namespace pizarra {

class GuidedSearch {
 public:
  // The bound counts every action. All arguments outlive the search.
  GuidedSearch(const Problem& problem, const Exclusions& exclusions, const DeadEnds& dead_ends, LandmarkBound& bound,
               const Budget& budget, const std::function<bool()>& cancelled);

  // A shortest plan; `none` when every state that can be reached was seen; its culprits are all the goals.
  Outcome run();

 private:
  struct Reached {
    Bits state;
    std::size_t from;
    std::size_t action;
    std::size_t steps;
    std::size_t at_least;  // steps to the goals
    bool expanded = false;
  };
  void reach(Bits state, std::size_t from, std::size_t action, std::size_t steps);
  void open(std::size_t index);
  void expand(std::size_t index);
  Outcome plan_to(std::size_t index) const;
  Outcome ended(Outcome::Kind kind, std::string spent = {}) const;

  const Problem& problem_;
  const Exclusions& exclusions_;
  const DeadEnds& dead_ends_;
  LandmarkBound& bound_;
  const Budget& budget_;
  const std::function<bool()>& cancelled_;
  std::vector<Reached> reached_;
  std::unordered_map<Bits, std::size_t, HashBits> index_;  // looked up only
  std::vector<std::vector<std::size_t>> open_;             // by total length; the newest first
  std::size_t nodes_ = 0;
};

}  // namespace pizarra
