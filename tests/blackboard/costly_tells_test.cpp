// Telling and retracting facts by their keys counts the work of the indexes as facts looked at: what the indexes take.

#include <gtest/gtest.h>

#include "blackboard/limits.hpp"
#include "blackboard/server/workload.hpp"
#include "blackboard/store/store.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

class CostlyTells : public testing::Test {
 protected:
  static constexpr std::size_t arguments = 8;
  static constexpr std::size_t facts = 100;

  CostlyTells() {
    EXPECT_TRUE(store_
                    .declare({relation("(relation big ((n integer) (a integer) (b integer) (c integer) (d integer) "
                                       "(e integer) (f integer) (g integer) (h integer)) (key n))")})
                    .has_value());
    EXPECT_EQ(tell(facts), 0U);
  }

  static Datum fact(std::size_t n, std::size_t other) {
    std::vector<Datum> items{"big"_sym, to_datum(n)};
    for (std::size_t i = 0; i < arguments; ++i) items.push_back(to_datum(other + i));
    return Datum::list(std::move(items));
  }
  // As how many facts looked at it counts, together.
  std::size_t done(const Transaction& transaction) {
    std::size_t examined = 0;
    EXPECT_TRUE(store_.transact("alice", transaction, Time(), examined).has_value());
    return examined;
  }
  static Transaction tells(std::size_t many, std::size_t other) {
    Transaction transaction;
    for (std::size_t n = 0; n < many; ++n) transaction.tell(fact(n, other));
    return transaction;
  }
  std::size_t tell(std::size_t many) { return done(tells(many, ++told_)); }
  void make_indexes(std::size_t by_values, bool by_order) {
    for (std::size_t i = 0; i < arguments; ++i) {
      std::string asked = "(big ?";
      for (std::size_t j = 0; j < arguments; ++j) asked += j == i ? " -1" : " ?";
      if (i < by_values) ask(asked + ")");
      if (!by_order || i >= 4) continue;
      asked = "(and (big ?";
      for (std::size_t j = 0; j < arguments; ++j) asked += j == i ? " ?x" : " ?";
      ask(asked + ") (< ?x -1))");
    }
  }
  void ask(const std::string& asked) { EXPECT_TRUE(store_.ask(query(asked)).has_value()) << asked; }

  store::Store store_;
  std::size_t told_ = 0;
};

TEST_F(CostlyTells, CountByTheIndexesThatTheyEnter) {
  make_indexes(1, false);
  const std::size_t of_one = tell(facts);
  EXPECT_GE(of_one, 8 * facts);
  make_indexes(arguments, true);
  EXPECT_EQ(tell(facts), 12 * of_one);
}

TEST_F(CostlyTells, RetractedByTheirKeysCountTheSame) {
  make_indexes(arguments, true);
  Transaction retracting;
  for (std::size_t n = 0; n < facts; ++n) {
    retracting.retract(query("(big " + std::to_string(n) + " ? ? ? ? ? ? ? ?)").clauses.front().form);
  }
  EXPECT_GE(done(retracting), 4 * 12 * facts);
}

TEST_F(CostlyTells, OneNeedsNoTurnWhateverItsRelationHas) {
  make_indexes(arguments, true);
  EXPECT_LE(tell(1), server::Workload::out_of_turn);
}

TEST_F(CostlyTells, BeyondTheBoundAreRefusedAndChangeNothing) {
  make_indexes(arguments, true);
  const Revision before = store_.revision();
  const Result<Revision> refused = store_.transact("alice", tells(2900, 0), Time());
  ASSERT_FALSE(refused.has_value());
  EXPECT_EQ(refused.error().symbol, "too-costly");
  EXPECT_NE(refused.error().sentence.find("indexes"), std::string::npos) << refused.error().sentence;
  EXPECT_EQ(store_.revision(), before);
  EXPECT_GT(tell(1000), 0U);
}

}  // namespace
}  // namespace pizarra
