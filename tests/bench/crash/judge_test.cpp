// The judge finds what is planted in what clients say they were told, or in what the journal has in the end.

#include "tests/bench/crash/judge.hpp"

#include <gtest/gtest.h>

namespace pizarra::bench {
namespace {

using Said = Report::Kind;

class JudgeOfTheOrdeal : public testing::Test {
 protected:
  JudgeOfTheOrdeal() {
    EXPECT_TRUE(store_.declare(crash_relations()));
    // Made, and not yet made.
    has(list("effect"_sym, 1, 1, 100));
    has(list("item"_sym, 1, 2));
    has(list("register"_sym, 7, 5));
    judge_.hear({Said::told, 1, 1});
    judge_.hear({Said::made, 1, 1});
    judge_.hear({Said::told, 1, 2});
    judge_.hear({Said::got, 1, 1});
    put(0, 5, 10, 20);
  }
  void has(Datum fact) { ASSERT_TRUE(store_.transact("planted", Transaction().tell(std::move(fact)), Time())); }
  void put(std::int64_t expected, std::int64_t value, std::int64_t called, std::int64_t answered) {
    Operation put{Operation::Kind::compare, Operation::Outcome::done, expected, value, called, answered};
    judge_.hear({Said::answered, 7, value, put});
  }
  Verdict verdict() const { return judge_.judge(store_); }

  store::Store store_;
  Judge judge_;
};

TEST_F(JudgeOfTheOrdeal, FindsNothingWhereNothingIs) {
  EXPECT_EQ(verdict().acknowledged, 4u);
  EXPECT_EQ(verdict().operations, 1u);
  EXPECT_EQ(verdict().lost + verdict().duplicated_effects + verdict().gaps + verdict().not_linearizable, 0u);
  EXPECT_EQ(judge_.unmade(), 1u);
}

TEST_F(JudgeOfTheOrdeal, FindsWhatWasAcknowledgedAndIsGone) {
  judge_.hear({Said::told, 1, 3});
  judge_.hear({Said::made, 1, 2});
  EXPECT_EQ(verdict().lost, 2u);
}

TEST_F(JudgeOfTheOrdeal, TakesWhatSomebodyHoldsForThere) {
  const LeaseId lease = store_.lease(Duration(1'000'000), Time()).value();
  ASSERT_TRUE(store_.take("taker", list("item"_sym, 1, 2), lease, Time()).value());
  EXPECT_EQ(verdict().lost, 0u);
}

TEST_F(JudgeOfTheOrdeal, FindsWhatWasDoneTwice) {
  has(list("effect"_sym, 1, 1, 101));
  EXPECT_EQ(verdict().duplicated_effects, 1u);
  has(list("item"_sym, 1, 1));
  EXPECT_EQ(verdict().duplicated_effects, 2u);
}

TEST_F(JudgeOfTheOrdeal, FindsWhatWasTakenTwiceAndWhatIsStillThere) {
  judge_.hear({Said::got, 1, 1});
  EXPECT_EQ(verdict().duplicated_effects, 1u);
  has(list("token"_sym, 1, 1));
  EXPECT_EQ(verdict().duplicated_effects, 2u);
}

TEST_F(JudgeOfTheOrdeal, FindsAGapThatAWatcherSaw) {
  judge_.hear({Said::gap, 1, 1});
  EXPECT_EQ(verdict().gaps, 1u);
}

TEST_F(JudgeOfTheOrdeal, FindsAnUpdateThatWentOverAnotherAndOneThatIsGoneInTheEnd) {
  put(0, 6, 30, 40);
  EXPECT_EQ(verdict().not_linearizable, 1u);
  const Operation fine{.value = 5, .called = 50, .answered = 60};
  judge_.hear({Said::answered, 7, 6, fine});
  EXPECT_EQ(verdict().not_linearizable, 0u);
  put(5, 8, 1'000'070, 2'000'000);
  EXPECT_EQ(verdict().not_linearizable, 1u);
  const std::string unexplained = verdict().unexplained;
  EXPECT_TRUE(unexplained.starts_with("register 7:\n  at 0.000: put 5 for 0, answered at 0.000\n")) << unexplained;
  EXPECT_NE(unexplained.find("  at 1.000: put 8 for 5, answered at 2.000\n"), std::string::npos) << unexplained;
}

}  // namespace
}  // namespace pizarra::bench
