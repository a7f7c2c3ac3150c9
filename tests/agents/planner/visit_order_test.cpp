#include "agents/planner/guided/visit_order.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <set>

#include "blackboard/time/random.hpp"

namespace pizarra::planner {
namespace {

TEST(VisitOrder, RepeatsNothingWhereNothingGoesInCircles) {
  VisitOrder order(3);
  order.first_before_first(0, 1);
  order.first_before_last(1, 2);
  order.last_before_last(1, 2);
  EXPECT_EQ(order.fewest_repeats(), 0u);
}

TEST(VisitOrder, RepeatsOneVisitToBreakACircle) {
  VisitOrder order(2);
  order.first_before_first(0, 1);
  order.last_before_last(1, 0);
  EXPECT_EQ(order.fewest_repeats(), 1u);
}

TEST(VisitOrder, RepeatsTheOneVisitThatManyCirclesShare) {
  VisitOrder order(4);
  for (const std::size_t other : {1, 2, 3}) {
    order.first_before_first(0, other);
    order.last_before_last(other, 0);
  }
  EXPECT_EQ(order.fewest_repeats(), 1u);
}

TEST(VisitOrder, RepeatsEveryVisitThatIsCaughtInACircleOfItsOwn) {
  VisitOrder order(4);
  for (const std::size_t begin : {0, 2}) {
    order.first_before_first(begin, begin + 1);
    order.last_before_last(begin + 1, begin);
  }
  EXPECT_EQ(order.fewest_repeats(), 2u);
}

// By trying every choice of repeated visits: a first and a last time for each, one for both where it is not repeated.
std::size_t fewest_by_trying(std::size_t visits, const std::set<std::pair<std::size_t, std::size_t>>& edges) {
  std::size_t fewest = visits;
  for (std::size_t chosen = 0; chosen < std::size_t{1} << visits; ++chosen) {
    const auto node = [&](std::size_t time) {
      return time < visits || (chosen >> (time - visits) & 1) != 0 ? time : time - visits;
    };
    std::vector<Bits> after(2 * visits, Bits(2 * visits));
    for (const auto& [from, to] : edges) after[node(from)].set(node(to));
    for (std::size_t i = 0; i < visits; ++i) {
      if (node(visits + i) != i) after[i].set(visits + i);
    }
    for (std::size_t k = 0; k < 2 * visits; ++k) {
      for (std::size_t i = 0; i < 2 * visits; ++i) {
        if (after[i].test(k)) after[i] |= after[k];
      }
    }
    bool circle = false;
    for (std::size_t i = 0; i < 2 * visits; ++i) circle = circle || after[i].test(i);
    if (!circle) fewest = std::min(fewest, static_cast<std::size_t>(std::popcount(chosen)));
  }
  return fewest;
}

TEST(VisitOrder, FindsTheFewestRepeatsOfRandomOrders) {
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Random random(seed);
    const std::size_t visits = 2 + random.below(5);
    VisitOrder order(visits);
    std::set<std::pair<std::size_t, std::size_t>> edges;
    for (std::size_t i = random.below(3 * visits); i > 0; --i) {
      const std::size_t a = random.below(visits);
      const std::size_t b = random.below(visits);
      if (a == b) continue;
      // First times follow one ranking and last times another, as what must come first and last does.
      if (random.below(2) == 0) {
        order.first_before_first(std::min(a, b), std::max(a, b));
        edges.emplace(std::min(a, b), std::max(a, b));
      } else if (random.below(2) == 0) {
        order.first_before_last(a, b);
        edges.emplace(a, visits + b);
      } else {
        order.last_before_last(std::max(a, b), std::min(a, b));
        edges.emplace(visits + std::max(a, b), visits + std::min(a, b));
      }
    }
    EXPECT_EQ(order.fewest_repeats(), fewest_by_trying(visits, edges)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pizarra::planner
