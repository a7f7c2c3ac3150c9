#include "agents/planner/guided/relaxed_landmarks.hpp"

#include <gtest/gtest.h>

#include "agents/planner/reach/relaxed_reach.hpp"
#include "agents/planner/task/grounding.hpp"
#include "tests/agents/planner/planning_domains.hpp"

namespace pizarra::planner {
namespace {

constexpr std::uint32_t kinds = 70;  // more than a machine word has bits

Bits all_actions(const Problem& problem) {
  Bits all(problem.actions.size());
  for (std::size_t i = 0; i < problem.actions.size(); ++i) all.set(i);
  return all;
}

// By leaving out every kind in turn.
void expect_what_leaving_out_shows(const Problem& problem, const std::vector<std::uint32_t>& kind_of,
                                   RelaxedLandmarks& landmarks, const Bits& state) {
  RelaxedReach reach(problem, all_actions(problem));
  landmarks.from(state);
  reach.from(state, Bits(problem.actions.size()));
  for (std::size_t fact = 0; fact < problem.facts.size(); ++fact) {
    EXPECT_EQ(landmarks.reached(fact), reach.facts().test(fact));
  }
  for (std::uint32_t kind = 0; kind < kinds; ++kind) {
    Bits left_out(problem.actions.size());
    for (std::size_t i = 0; i < kind_of.size(); ++i) {
      if (kind_of[i] == kind) left_out.set(i);
    }
    reach.from(state, left_out);
    for (std::size_t fact = 0; fact < problem.facts.size(); ++fact) {
      EXPECT_EQ(landmarks.of_fact(fact).test(kind), !reach.facts().test(fact)) << "kind " << kind;
    }
    for (std::uint32_t i = 0; i < kind_of.size(); ++i) {
      EXPECT_EQ(landmarks.of_all({i}).test(kind), !reach.actions().test(i)) << "kind " << kind;
    }
  }
}

TEST(RelaxedLandmarks, AreTheKindsOfActionsWithoutWhichAFactIsOutOfReach) {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const Result<Problem> problem = ground(seed % 2 == 0 ? random_blocks(3, random) : random_logistics(random));
    ASSERT_TRUE(problem);
    std::vector<std::uint32_t> kind_of;
    for (std::size_t i = 0; i < problem->actions.size(); ++i) {
      kind_of.push_back(random.below(3) == 0 ? RelaxedLandmarks::no_kind
                                             : static_cast<std::uint32_t>(random.below(kinds)));
    }
    RelaxedLandmarks landmarks(*problem, all_actions(*problem), kind_of, kinds);
    Bits state = problem->initials;
    for (int step = 0; step < 3; ++step) {
      expect_what_leaving_out_shows(*problem, kind_of, landmarks, state);
      for (const GroundAction& action : problem->actions) {
        if (!applicable(action, state) || random.below(2) == 0) continue;
        state = after(state, action);
        break;
      }
    }
  }
}

}  // namespace
}  // namespace pizarra::planner
