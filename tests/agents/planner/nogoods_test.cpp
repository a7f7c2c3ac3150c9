#include "agents/planner/graphplan/nogoods.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "blackboard/time/random.hpp"

namespace pizarra::planner {
namespace {

Bits bits(const std::vector<std::size_t>& facts, std::size_t size = 20) {
  Bits all(size);
  for (const std::size_t fact : facts) all.set(fact);
  return all;
}

TEST(Nogoods, AreFoundInAllGoalsThatHoldThemUpToTheirLevel) {
  Nogoods nogoods;
  nogoods.add({2, 5}, 3);
  EXPECT_TRUE(nogoods.find(bits({1, 2, 5}), 3));
  EXPECT_TRUE(nogoods.find(bits({2, 5}), 1));
  EXPECT_FALSE(nogoods.find(bits({2, 5}), 4));
  EXPECT_FALSE(nogoods.find(bits({2, 4}), 3));
  nogoods.add({2, 5}, 6);
  EXPECT_TRUE(nogoods.find(bits({2, 5}), 6));
  EXPECT_EQ(nogoods.entries().size(), 1u);
}

TEST(Nogoods, AnswerAsAListOfSetsWould) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    const auto some = [&](std::uint64_t one_in) {
      std::vector<std::size_t> facts;
      for (std::size_t i = 0; i < 20; ++i) {
        if (random.below(one_in) == 0) facts.push_back(i);
      }
      if (facts.empty()) facts.push_back(random.below(20));
      return facts;
    };
    Nogoods nogoods;
    std::vector<std::pair<std::vector<std::size_t>, std::size_t>> plain;
    for (int i = 0; i < 60; ++i) {
      plain.emplace_back(some(5), 1 + random.below(5));
      nogoods.add(plain.back().first, plain.back().second);
    }
    for (int i = 0; i < 100; ++i) {
      const Bits goals = bits(some(3));
      const std::size_t level = 1 + random.below(6);
      const bool expected = std::ranges::any_of(
          plain, [&](const auto& nogood) { return nogood.second >= level && bits(nogood.first).subset_of(goals); });
      const std::optional<std::size_t> found = nogoods.find(goals, level);
      ASSERT_EQ(found.has_value(), expected) << "seed " << seed;
      if (!found) continue;
      EXPECT_TRUE(bits(nogoods.entries()[*found].facts).subset_of(goals));
      EXPECT_GE(nogoods.entries()[*found].level, level);
    }
  }
}

}  // namespace
}  // namespace pizarra::planner
