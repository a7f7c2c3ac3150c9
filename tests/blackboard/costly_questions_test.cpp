// What counts as having looked at facts: how much of them is compared, not only how many they are.

#include <gtest/gtest.h>

#include "blackboard/store/evaluate.hpp"
#include "blackboard/store/indexing.hpp"
#include "blackboard/store/store.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

class CostlyQuestions : public testing::Test {
 protected:
  static constexpr std::size_t few = 16;

  CostlyQuestions() {
    EXPECT_TRUE(store_.declare({relation("(relation big ((n integer) (what datum)) (key n))")}).has_value());
  }

  // Facts which say the same but for the last of their elements.
  void tell_lists(std::size_t facts, std::size_t elements) {
    for (std::size_t n = 0; n < facts; ++n) {
      std::vector<Datum> items(elements, "a"_sym);
      items.back() = to_datum(n);
      tell(n, Datum::list(std::move(items)));
    }
  }
  void tell(std::size_t n, const Datum& what) {
    EXPECT_TRUE(store_.transact("alice", Transaction().tell(list("big"_sym, n, what)), Time()).has_value());
  }
  std::size_t examined(const std::string& asked) {
    std::size_t examined = 0;
    EXPECT_TRUE(store::evaluate(query(asked), store_.tables(), examined).has_value()) << asked;
    return examined;
  }
  std::string ask(const std::string& asked) {
    const Result<Answers> answers = store_.ask(query(asked));
    return answers ? "ok" : answers.error().symbol;
  }

  store::Store store_;
};

TEST_F(CostlyQuestions, FactsOfOrdinarySizeCountForOneEach) {
  for (std::size_t n = 0; n < few; ++n) tell(n, "same"_sym);
  EXPECT_EQ(examined("(big ?n ?l)"), few);
  EXPECT_EQ(examined("(and (big ?n ?l) (big ?m ?k) (/= ?l ?k))"), few + few * few);
}

// The first comparison of a fact takes no longer than the fact.
TEST_F(CostlyQuestions, WhatLooksAtNoFactCountsToo) {
  for (std::size_t n = 0; n < few; ++n) tell(n, to_datum(100'000 + n));
  EXPECT_EQ(examined("(and (big ?n ?l) (/= ?l a))"), few);
  EXPECT_EQ(examined("(and (big ?n ?l) (/= ?l a) (/= ?l b) (/= ?l c))"), 3 * few);
  EXPECT_EQ(examined("(and (big ?n ?l) (big ?l ?k))"), 2 * few);
  EXPECT_EQ(examined("(and (big ?n ?l) (not (big ?l ?)) (not (big ?l 1)))"), 3 * few);
}

// So few are looked through, whatever is asked.
TEST_F(CostlyQuestions, FactsCountForMoreWhereMoreOfThemIsCompared) {
  tell_lists(few, 1600);
  EXPECT_LE(examined("(big ?n ?l)"), few);
  constexpr std::size_t pairs = few * (few - 1);
  for (const std::string asked : {"(and (big ?n ?l) (big ?m ?k) (= ?l ?k))", "(and (big ?n ?l) (big ?m ?l))"}) {
    EXPECT_GE(examined(asked), pairs * 99) << asked;
    EXPECT_LE(examined(asked), pairs * 200) << asked;
  }
}

TEST_F(CostlyQuestions, WhatComparesTooMuchIsRefused) {
  tell_lists(few, 20'000);
  EXPECT_EQ(ask("(query (big ?n ?l) (limit 5))"), "ok");
  EXPECT_EQ(ask("(and (big ?n ?l) (big ?m ?k) (= ?l ?k) (/= ?n ?m))"), "too-costly");
  EXPECT_EQ(ask("(and (big ?n ?l) (big ?m ?l) (/= ?n ?m))"), "too-costly");
}

TEST_F(CostlyQuestions, WhatSortingComparesCountsAlike) {
  tell_lists(700, 2400);
  const store::Indexing no_index(store::Indexing::May::not_make);
  const std::string all = "(query (big ?n ?l) (order ";
  EXPECT_EQ(ask(all + "?l) (limit 3))"), "ok");
  EXPECT_EQ(ask(all + "?n) (limit 80))"), "ok");
  EXPECT_EQ(ask(all + "?l) (limit 300))"), "too-costly");
  EXPECT_EQ(ask(all + "(down ?l)) (limit 300))"), "too-costly");
}

TEST_F(CostlyQuestions, AnOrderByListsIsKeptByNoIndexAndCounts) {
  tell_lists(1000, 1600);
  EXPECT_EQ(ask("(query (big ?n ?l) (order ?l) (limit 300))"), "too-costly");
  EXPECT_EQ(ask("(query (big ?n ?l) (order ?n) (limit 30))"), "ok");
}

TEST_F(CostlyQuestions, WhatGoesByAPatternCountsForMoreThanALookAndForEachIndex) {
  for (std::size_t n = 0; n < 20'000; ++n) tell(n, "a"_sym);
  const Transaction all = Transaction().retract(read("(big ? ?)"));
  for (const std::string asked : {"(big ?n b)", "(query (big ?n ?l) (order ?n) (limit 1))"}) {
    ASSERT_EQ(ask(asked), "ok");
  }
  const Result<Revision> refused = store_.transact("alice", all, Time());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().symbol, "too-costly");
  EXPECT_EQ(store_.size(), 20'000U);
  for (std::size_t n = 0; n < 10'000; ++n) {
    ASSERT_TRUE(store_.transact("alice", Transaction().retract(list("big"_sym, n, "?"_sym)), Time()).has_value());
  }
  EXPECT_TRUE(store_.transact("alice", all, Time()).has_value());
  EXPECT_EQ(store_.size(), 0U);
}

TEST_F(CostlyQuestions, WhatATransactionRequiresCountsAlike) {
  const Datum one = Datum::list(std::vector<Datum>(20'000, "a"_sym));
  std::vector<Datum> other(20'000, "a"_sym);
  other.back() = "b"_sym;
  tell(1, list(one, Datum::list(std::move(other))));
  const auto require = [&](std::size_t times) {
    Transaction transaction;
    transaction.preconditions.assign(times, Transaction::Absent{read("(big ? (?l ?l))")});
    const Result<Revision> done = store_.transact("alice", transaction, Time());
    return done ? "ok" : done.error().symbol;
  };
  EXPECT_EQ(require(100), "ok");
  EXPECT_EQ(require(400), "too-costly");
}

TEST_F(CostlyQuestions, WhatATransactionRetractsCountsAlike) {
  std::vector<Datum> other(20'000, "a"_sym);
  const Datum one = Datum::list(other);
  other.back() = "b"_sym;
  const Datum fact = list("big"_sym, 1, list(one, Datum::list(std::move(other))));
  tell(1, fact[2]);
  const auto retract = [&](std::size_t times, bool its_own) {
    Transaction transaction;
    if (its_own) transaction.tell(fact);
    for (std::size_t i = 0; i < times; ++i) transaction.retract(read("(big ? (?l ?l))"));
    const Result<Revision> done = store_.transact("alice", transaction, Time());
    return done ? "ok" : done.error().symbol;
  };
  EXPECT_EQ(retract(100, false), "ok");
  EXPECT_EQ(retract(400, false), "too-costly");
  ASSERT_TRUE(store_.transact("alice", Transaction().retract(read("(big ? ?)")), Time()).has_value());
  EXPECT_EQ(retract(40, true), "ok");
  ASSERT_TRUE(store_.transact("alice", Transaction().retract(read("(big ? ?)")), Time()).has_value());
  EXPECT_EQ(retract(400, true), "too-costly");
}

TEST_F(CostlyQuestions, WhatIsTooMuchToRetractAtOnceIsRefusedWithAWayOut) {
  for (std::size_t n = 0; n < 1000; ++n) tell(n, "a"_sym);
  Transaction transaction;
  for (std::size_t i = 0; i < 300; ++i) transaction.retract(read("(big ? ?)"));
  const Result<Revision> done = store_.transact("alice", transaction, Time());
  ASSERT_FALSE(done.has_value());
  EXPECT_EQ(done.error().symbol, "too-costly");
  EXPECT_NE(done.error().sentence.find("(limit COUNT) and retract these by their keys"), std::string::npos);
}

TEST_F(CostlyQuestions, WhatWentSinceARevisionCountsWhereNothingMayHaveChanged) {
  for (std::size_t n = 0; n < store::FactTable::max_removals; ++n) tell(n, "a"_sym);
  const Revision before = store_.revision();
  ASSERT_TRUE(store_.transact("alice", Transaction().retract(read("(big ? ?)")), Time()).has_value());
  const auto require = [&](std::size_t times) {
    Transaction transaction;
    transaction.preconditions.assign(times, Transaction::Unchanged{read("(big ? b)"), before});
    const Result<Revision> done = store_.transact("alice", transaction, Time());
    return done ? "ok" : done.error().symbol;
  };
  EXPECT_EQ(require(10), "ok");
  EXPECT_EQ(require(100), "too-costly");
}

TEST_F(CostlyQuestions, AnIndexThatAQuestionMakesIsForAllToCome) {
  for (std::size_t n = 0; n < 300; ++n) tell(n, list("a"_sym, n % 3, std::string(6400, 'x')));
  const std::string asked = "(big ?n (a 1 \"" + std::string(6400, 'x') + "\"))";
  const std::size_t first = examined(asked);
  EXPECT_EQ(examined(asked), first);
}

}  // namespace
}  // namespace pizarra
