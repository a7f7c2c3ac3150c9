// The checker of histories finds what is planted, and agrees with trying every order.

#include "tests/bench/crash/linearizable.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

namespace pizarra::bench {
namespace {

using Kind = Operation::Kind;
using Outcome = Operation::Outcome;

Operation read(std::int64_t value, std::int64_t called, std::int64_t answered) {
  return {Kind::read, Outcome::done, 0, value, called, answered};
}
Operation put(std::int64_t expected, std::int64_t value, std::int64_t called, std::int64_t answered,
              Outcome outcome = Outcome::done) {
  return {Kind::compare, outcome, expected, value, called, answered};
}

TEST(Linearizable, IsWhatHappensOneByOne) {
  EXPECT_TRUE(is_linearizable({}));
  EXPECT_TRUE(is_linearizable({read(0, 0, 1), put(0, 5, 2, 3), read(5, 4, 5), put(0, 6, 6, 7, Outcome::refused)}));
}

TEST(Linearizable, IsWhatOverlapsInAnyOrder) {
  EXPECT_TRUE(is_linearizable({put(0, 5, 0, 10), read(0, 1, 9), read(5, 2, 8)}));
  EXPECT_TRUE(is_linearizable({put(5, 6, 0, 10), put(0, 5, 1, 9), read(6, 11, 12)}));
}

TEST(Linearizable, IsWhatHappensUnansweredAtAnyTimeOrNever) {
  const Operation lost = put(0, 5, 0, Operation::never, Outcome::unknown);
  EXPECT_TRUE(is_linearizable({lost, read(0, 1, 2), read(0, 3, 4)}));
  EXPECT_TRUE(is_linearizable({lost, read(0, 1, 2), read(5, 3, 4)}));
  EXPECT_FALSE(is_linearizable({lost, read(5, 1, 2), read(0, 3, 4)}));
}

TEST(Linearizable, IsNoOldAnswerAfterANewerOne) {
  EXPECT_FALSE(is_linearizable({put(0, 5, 0, 1), read(0, 2, 3)}));
  EXPECT_FALSE(is_linearizable({put(0, 5, 0, 10), read(5, 1, 2), read(0, 3, 4)}));
}

TEST(Linearizable, IsNoUpdateThatWentOverAnother) {
  EXPECT_FALSE(is_linearizable({put(0, 5, 0, 1), put(0, 6, 0, 1)}));
  EXPECT_FALSE(is_linearizable({put(0, 5, 0, 1), put(5, 6, 2, 3), read(5, 4, 5)}));
}

TEST(Linearizable, IsNoRefusalWhereTheValueStood) {
  EXPECT_FALSE(is_linearizable({put(0, 5, 0, 1), put(5, 6, 2, 3, Outcome::refused), read(5, 4, 5)}));
}

TEST(Linearizable, IsNoValueThatNobodyWroteOrThatWasRefused) {
  EXPECT_FALSE(is_linearizable({read(9, 0, 1)}));
  EXPECT_FALSE(is_linearizable({put(4, 5, 0, 1, Outcome::refused), read(5, 2, 3)}));
}

// Every order, and every choice of those that nobody knows of.
bool could_be(const std::vector<Operation>& history) {
  std::vector<std::size_t> order(history.size());
  std::iota(order.begin(), order.end(), 0);
  const auto fits = [&](std::uint32_t happened) {
    std::int64_t value = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
      const Operation& one = history[order[i]];
      if ((happened >> order[i] & 1) == 0) continue;
      for (std::size_t before = 0; before < i; ++before) {
        if ((happened >> order[before] & 1) != 0 && one.answered < history[order[before]].called) return false;
      }
      const bool same = value == (one.kind == Kind::read ? one.value : one.expected);
      if (same == (one.outcome == Outcome::refused)) return false;
      if (one.outcome != Outcome::refused) value = one.value;
    }
    return true;
  };
  do {
    for (std::uint32_t happened = 0; happened < 1u << history.size(); ++happened) {
      bool all_known = true;
      for (std::size_t i = 0; i < history.size(); ++i) {
        all_known = all_known && (history[i].outcome == Outcome::unknown || (happened >> i & 1) != 0);
      }
      if (all_known && fits(happened)) return true;
    }
  } while (std::ranges::next_permutation(order).found);
  return false;
}

TEST(Linearizable, IsWhatSomeOrderExplains) {
  std::mt19937 random(7);
  const auto below = [&](std::int64_t bound) { return static_cast<std::int64_t>(random() % bound); };
  int sound = 0;
  constexpr int histories = 1500;
  for (int i = 0; i < histories; ++i) {
    std::vector<Operation> history;
    for (std::int64_t n = 1; n <= 5; ++n) {
      const std::int64_t called = below(12);
      const std::int64_t answered = called + 1 + below(6);
      const std::int64_t chance = below(6);
      const std::int64_t some = below(n);
      if (chance < 2) history.push_back(read(some, called, answered));
      if (chance == 2 || chance == 3) history.push_back(put(some, n, called, answered));
      if (chance == 4) history.push_back(put(some, n, called, answered, Outcome::refused));
      if (chance == 5) history.push_back(put(some, n, called, Operation::never, Outcome::unknown));
    }
    const bool expected = could_be(history);
    sound += expected ? 1 : 0;
    ASSERT_EQ(is_linearizable(history), expected) << "history " << i;
  }
  EXPECT_GT(sound, histories / 20);
  EXPECT_LT(sound, histories - histories / 20);
}

// As long as those of a bench: a register that many use at once, and one stale read at the end of it.
TEST(Linearizable, IsFoundInALongHistory) {
  std::mt19937 random(11);
  std::vector<Operation> history;
  std::int64_t value = 0;
  for (std::int64_t n = 1; n <= 4000; ++n) {
    const std::int64_t moment = 10 * n;
    const std::int64_t called = moment - static_cast<std::int64_t>(random() % 60);
    const std::int64_t answered = moment + static_cast<std::int64_t>(random() % 60);
    const auto chance = random() % 10;
    if (chance < 5) {
      history.push_back(read(value, called, answered));
    } else if (chance < 7) {
      history.push_back(put(value + 1'000'000, n, called, answered, Outcome::refused));
    } else {
      const bool answer_lost = chance == 9;
      history.push_back(put(value, n, called, answer_lost ? Operation::never : answered,
                            answer_lost ? Outcome::unknown : Outcome::done));
      value = n;
    }
  }
  EXPECT_TRUE(is_linearizable(history));
  history.push_back(read(history.front().value + 5'000'000, 50'000, 50'010));
  EXPECT_FALSE(is_linearizable(history));
}

}  // namespace
}  // namespace pizarra::bench
