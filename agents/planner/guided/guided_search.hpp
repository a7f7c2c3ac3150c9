#pragma once

// A* for problems in which every action needs one and the same resource, so that no step has more than one: under the
// landmark bound, which is often exact there.
//
//   GuidedSearch search(problem, nearness, bound, &dead_ends);
//   Outcome outcome = search.run(budget, cancelled);
//   problem.initials = elsewhere;
//   outcome = search.run(budget, cancelled);             // cheaper: it remembers
//
// The bound is costly, so it is computed only when a state's turn comes. Of states that may be equally good, those with
// less left to do come first. So it is computed little more than once a step where it is exact. The distances that
// a search learns stay true wherever the next search begins (Koenig & Likhachev, "Adaptive A*", 2005). Budget::nodes
// counts states for which the bound was asked.

#include <unordered_map>

#include "agents/planner/distance/nearness.hpp"
#include "agents/planner/guided/landmark_bound.hpp"
#include "agents/planner/reach/dead_ends.hpp"

namespace pizarra::planner {

class GuidedSearch {
 public:
  // The bound counts every action. All arguments outlive the search; dead ends need not be known.
  GuidedSearch(const Problem& problem, Nearness& nearness, LandmarkBound& bound, const DeadEnds* dead_ends);

  // A shortest plan from the problem's initial facts, which respect the exclusions; `none` when every state that can be
  // reached was seen; its culprits are all the goals.
  Outcome run(const Budget& budget, const std::function<bool()>& cancelled);

 private:
  struct Known {
    Bits state;
    std::size_t at_least = 0;  // steps to the goals
    bool asked = false;        // whether the bound is in at_least
    // Of the search under way:
    std::size_t run = 0;
    std::size_t from = 0;
    std::size_t action = 0;
    std::size_t steps = 0;
    bool expanded = false;
  };
  std::size_t know(const Bits& state);
  static constexpr std::size_t no_way = static_cast<std::size_t>(-1);
  void ask_bound(Known& known);
  void reach(const Bits& state, std::size_t from, std::size_t action, std::size_t steps);
  void open(std::size_t index);
  void expand(std::size_t index, const std::function<bool()>& cancelled);
  void learn(std::size_t length);
  Outcome plan_to(std::size_t index);
  Outcome ended(Outcome::Kind kind, std::string spent = {}) const;

  const Problem& problem_;
  Nearness& nearness_;
  LandmarkBound& bound_;
  const DeadEnds* dead_ends_;
  std::vector<Known> known_;
  std::unordered_map<Bits, std::size_t, HashBits> index_;  // looked up only
  std::vector<std::vector<std::size_t>> open_;             // by total length; the newest first
  std::vector<std::size_t> expanded_;
  std::size_t run_ = 0;
  std::size_t nodes_ = 0;
};

}  // namespace pizarra::planner
