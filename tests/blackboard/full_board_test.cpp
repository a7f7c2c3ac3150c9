// A board that holds as many facts as it may.

#include <gtest/gtest.h>

#include "blackboard/limits.hpp"
#include "blackboard/store/store.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

// One text in all of them, so that the test itself takes little memory.
TEST(HeavyBoard, TakesFactsUpToAGigabyteOfThem) {
  store::Store store;
  ASSERT_TRUE(store.declare({relation("(relation note ((n integer) (text datum)) (key n))")}).has_value());
  const Datum text = to_datum(std::string(1'000'000, 'x'));
  const auto transact = [&](const Transaction& transaction) {
    const Result<Revision> done = store.transact("alice", transaction, Time());
    return done ? "ok" : done.error().sentence;
  };
  const auto tell = [&](int n, const Datum& what) { return transact(Transaction().tell(list("note"_sym, n, what))); };
  const std::string full = "the board is full: its facts take " + std::to_string(limits::board_bytes) + " bytes";
  int told = 0;
  while (told < 1100 && tell(told, text) == "ok") ++told;
  EXPECT_EQ(told, 1073);
  EXPECT_EQ(tell(told, text), full);
  EXPECT_EQ(tell(0, to_datum(std::string(1'000'000, 'y'))), "ok") << "in place of another";
  EXPECT_EQ(transact(Transaction().retract(read("(note 1 ?)"))), "ok");
  const LeaseId lease = store.lease(10s, Time()).value();
  const FactId taken = store.take("alice", read("(note 2 ?)"), lease, Time()).value()->id;
  EXPECT_EQ(tell(1, text), "ok");
  EXPECT_EQ(tell(2, text), full) << "what is taken may come back";
  EXPECT_EQ(transact(Transaction().settle(taken).tell(list("note"_sym, 2, text))), "ok");
  EXPECT_EQ(tell(told, text), full);
}

class FullBoard : public testing::Test {
 protected:
  FullBoard() {
    EXPECT_TRUE(store_.declare({relation("(relation note ((n integer) (text symbol)) (key n))")}).has_value());
    constexpr std::size_t at_once = 8000;
    for (std::size_t begin = 0; begin < limits::facts; begin += at_once) {
      Transaction some;
      for (std::size_t n = begin; n < begin + at_once; ++n) some.tell(list("note"_sym, n, "x"_sym));
      EXPECT_EQ(transact(some), "ok");
    }
    EXPECT_EQ(store_.size(), limits::facts);
  }

  std::string transact(const Transaction& transaction) {
    const Result<Revision> done = store_.transact("alice", transaction, Time());
    return done ? "ok" : done.error().symbol;
  }
  std::string tell(const std::string& fact) { return transact(Transaction().tell(read(fact))); }

  store::Store store_;
};

TEST_F(FullBoard, TakesWhateverDoesNotAddToIt) {
  EXPECT_EQ(tell("(note -1 x)"), "too-large");
  EXPECT_EQ(tell("(note 5 y)"), "ok") << "in place of another";
  EXPECT_EQ(transact(Transaction().tell(read("(note 6 y)")).tell(read("(note -1 x)"))), "too-large");
  EXPECT_EQ(transact(Transaction().retract(read("(note 7 ?)"))), "ok");
  EXPECT_EQ(tell("(note -1 x)"), "ok");
  EXPECT_EQ(tell("(note -2 x)"), "too-large");
  EXPECT_EQ(store_.size(), limits::facts);
}

TEST_F(FullBoard, HasWhatIsTakenUntilItIsSettled) {
  const LeaseId lease = store_.lease(10s, Time()).value();
  const FactId taken = store_.take("alice", read("(note 5 ?)"), lease, Time()).value()->id;
  EXPECT_EQ(tell("(note -1 x)"), "too-large") << "it may come back";
  EXPECT_EQ(transact(Transaction().settle(taken).tell(read("(note -1 x)"))), "ok");
  EXPECT_EQ(tell("(note -2 x)"), "too-large");
  ASSERT_TRUE(store_.take("alice", read("(note 6 ?)"), lease, Time()).value());
  ASSERT_TRUE(store_.release(lease, Time()).has_value());
  EXPECT_EQ(store_.size(), limits::facts);
}

}  // namespace
}  // namespace pizarra
