// How much goes with a lease before others are served.

#include <algorithm>
#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

class Lapsing : public testing::Test {
 protected:
  static constexpr std::size_t at_once = 1000;
  static constexpr std::size_t facts = 2 * at_once + 500;

  Lapsing() {
    EXPECT_TRUE(store_
                    .declare({relation("(relation note ((n integer)) (key n))"),
                              relation("(relation brief ((n integer)) (key n) (lease 1000))")})
                    .has_value());
    lease_ = store_.lease(1s, now_).value();
  }

  void tell(const std::string& relation, std::size_t n, LeaseId lease) {
    Transaction transaction;
    transaction.tell(list(Datum::symbol(relation), n), {}, lease);
    ASSERT_TRUE(store_.transact("alice", transaction, now_).has_value());
  }
  void tell_all(const std::string& relation, LeaseId lease) {
    for (std::size_t n = 0; n < facts; ++n) tell(relation, n, lease);
  }
  void expire() { store_.expire(now_, now_); }
  bool stands(const std::string& asked) const { return !store_.ask(query(asked))->answers.empty(); }
  Result<Revision> tell_if_absent(const std::string& fact, const std::string& pattern) {
    Transaction transaction;
    transaction.preconditions.emplace_back(Transaction::Absent{read(pattern)});
    transaction.tell(read(fact));
    return store_.transact("bob", transaction, now_);
  }

  store::Store store_;
  Time now_{};
  LeaseId lease_ = 0;
};

TEST_F(Lapsing, OfALeaseGoesInPartsAndTheLeaseAtOnce) {
  tell_all("note", lease_);
  now_ += 2s;
  expire();
  // The lease counts as one of them.
  EXPECT_EQ(store_.size(), facts - at_once + 1);
  EXPECT_FALSE(store_.renew(lease_, now_).has_value());
  EXPECT_LE(*store_.next_expiry(), now_);
  expire();
  expire();
  EXPECT_EQ(store_.size(), 0U);
  EXPECT_EQ(store_.next_expiry(), std::nullopt);
}

TEST_F(Lapsing, WhatIsToldAnewMeanwhileStays) {
  tell_all("note", lease_);
  ASSERT_TRUE(store_.release(lease_, now_).has_value());
  ASSERT_EQ(store_.size(), facts - at_once);
  const LeaseId other = store_.lease(3600s, now_).value();
  tell("note", facts - 1, 0);
  tell("note", facts - 2, other);
  tell("note", 0, 0);
  for (int part = 0; part < 3; ++part) expire();
  EXPECT_EQ(store_.size(), 3U);
}

TEST_F(Lapsing, WhatIsTakenComesBackInPartsButNotWhatWasSettledMeanwhile) {
  tell_all("note", 0);
  FactId last = 0;
  for (std::size_t n = 0; n < facts; ++n) {
    last = store_.take("bob", list("note"_sym, n), lease_, now_).value()->id;
  }
  ASSERT_TRUE(store_.release(lease_, now_).has_value());
  EXPECT_EQ(store_.size(), at_once);
  Transaction settling;
  settling.settle(last);
  ASSERT_TRUE(store_.transact("bob", settling, now_).has_value());
  expire();
  expire();
  EXPECT_EQ(store_.size(), facts - 1);
}

TEST_F(Lapsing, FactsOfALeasedRelationGoInParts) {
  ASSERT_TRUE(store_.release(lease_, now_).has_value());
  tell_all("brief", 0);
  now_ += 2s;
  expire();
  EXPECT_EQ(store_.size(), facts - at_once);
  expire();
  expire();
  EXPECT_EQ(store_.size(), 0U);
}

TEST_F(Lapsing, LeasesUnderWhichNothingStandsGoInParts) {
  std::vector<LeaseId> leases{lease_};
  while (leases.size() < facts) leases.push_back(store_.lease(1s, now_).value());
  const auto standing = [&] { return std::ranges::count_if(leases, [&](LeaseId id) { return store_.stands(id); }); };
  now_ += 2s;
  expire();
  EXPECT_EQ(standing(), std::ptrdiff_t{facts - at_once});
  EXPECT_LE(*store_.next_expiry(), now_);
  expire();
  expire();
  EXPECT_EQ(standing(), 0);
  EXPECT_EQ(store_.next_expiry(), std::nullopt);
}

TEST_F(Lapsing, ASmallLeaseGoesAtOnceHoweverLargeAnotherIs) {
  tell_all("note", lease_);
  const LeaseId brief = store_.lease(1s, now_).value();
  const LeaseId released = store_.lease(3600s, now_).value();
  tell("note", facts, brief);
  tell("note", facts + 1, released);
  ASSERT_TRUE(store_.release(lease_, now_).has_value());
  ASSERT_TRUE(store_.release(released, now_).has_value());
  EXPECT_FALSE(stands("(note 2501)"));
  now_ += 2s;
  expire();
  EXPECT_FALSE(stands("(note 2500)"));
  EXPECT_TRUE(stands("(note 2499)"));
}

TEST_F(Lapsing, ALeaseGoesWhileManyFactsOfALeasedRelationDo) {
  tell_all("brief", 0);
  tell("note", 1, lease_);
  now_ += 2s;
  expire();
  EXPECT_FALSE(stands("(note 1)"));
  EXPECT_GE(store_.size(), facts - at_once);
  EXPECT_LT(store_.size(), facts);
}

TEST_F(Lapsing, FactsOfALeasedRelationGoWhileALargeLeaseDoes) {
  tell("brief", 1, 0);
  tell_all("note", lease_);
  now_ += 2s;
  expire();
  EXPECT_FALSE(stands("(brief 1)"));
}

TEST_F(Lapsing, WhatIsStillToGoIsNeitherTakenNorInTheWay) {
  tell_all("note", lease_);
  ASSERT_TRUE(store_.release(lease_, now_).has_value());
  ASSERT_TRUE(stands("(note 2499)"));
  EXPECT_EQ(store_.take("bob", list("note"_sym, 2499), 0, now_).value(), std::nullopt);
  EXPECT_EQ(store_.take("bob", list("note"_sym, "?n"_sym), 0, now_).value(), std::nullopt);
  EXPECT_TRUE(tell_if_absent("(note 2498)", "(note 2498)").has_value());
  EXPECT_FALSE(tell_if_absent("(note 2498)", "(note 2498)").has_value());
  EXPECT_EQ(store_.take("bob", list("note"_sym, "?n"_sym), 0, now_).value()->datum, list("note"_sym, 2498));
}

TEST_F(Lapsing, WhatIsTakenComesBackThoughWhatIsStillToGoHasItsKey) {
  const LeaseId holder = store_.lease(3600s, now_).value();
  tell("note", facts - 1, 0);
  ASSERT_TRUE(store_.take("bob", list("note"_sym, facts - 1), holder, now_).value().has_value());
  tell_all("note", lease_);
  ASSERT_TRUE(store_.release(lease_, now_).has_value());
  ASSERT_TRUE(store_.release(holder, now_).has_value());
  for (int part = 0; part < 3; ++part) expire();
  EXPECT_EQ(store_.size(), 1U);
  EXPECT_TRUE(stands("(note 2499)"));
}

// The costlier they are, the fewer go at once.
TEST_F(Lapsing, OfARelationWithIndexesGoesInSmallerParts) {
  tell_all("note", lease_);
  EXPECT_TRUE(store_.ask(query("(and (note ?n) (> ?n 1000000))")).has_value());
  const std::size_t looks = store_.tables().find("note")->second.looks_to_remove();
  ASSERT_GT(looks, store::Lapsing::lapsing_at_once / at_once);
  now_ += 2s;
  expire();
  const std::size_t gone = facts - store_.size();
  EXPECT_LE(gone, store::Lapsing::lapsing_at_once / looks + 1);
  EXPECT_GE(gone, store::Lapsing::lapsing_at_once / looks);
}

class LapsingBoard : public testing::Test {
 protected:
  static constexpr int facts = 5000;

  LapsingBoard() {
    EXPECT_TRUE(board_.declare("alice", {relation("(relation note ((n integer)) (key n))")}).has_value());
  }
  LeaseId lease_of_many() {
    const LeaseId lease = board_.lease(3600s).value();
    Transaction many;
    for (int n = 0; n < facts; ++n) many.tell(list("note"_sym, n), {}, lease);
    EXPECT_TRUE(board_.transact("alice", many).has_value());
    return lease;
  }
  std::size_t gone() const { return facts - board_.store().size(); }

  VirtualExecutor executor_;
  memory::MemoryBoard board_{executor_};
};

TEST_F(LapsingBoard, LapsesOnePartHoweverMuchIsAskedMeanwhileAndTheRestSoon) {
  ASSERT_TRUE(board_.release(lease_of_many()).has_value());
  const std::size_t part = gone();
  EXPECT_GT(part, 0U);
  for (int i = 0; i < 64; ++i) EXPECT_TRUE(board_.ask(query("(note 1)")).has_value());
  EXPECT_EQ(gone(), part);
  const Time begun = executor_.now();
  executor_.run_until([&] { return board_.store().size() == 0; });
  EXPECT_EQ(board_.store().size(), 0U);
  EXPECT_LE(executor_.now() - begun, 2ms * (facts / part));
}

TEST_F(LapsingBoard, ReleasesWhatIsFewAtOnceAndCountsItForWhoAsked) {
  for (int i = 0; i < 100; ++i) {
    const LeaseId lease = board_.lease(3600s).value();
    Transaction some;
    for (int n = 0; n < facts / 100; ++n) some.tell(list("note"_sym, i * facts / 100 + n), {}, lease);
    ASSERT_TRUE(board_.transact("alice", some).has_value());
    std::size_t examined = 0;
    EXPECT_TRUE(board_.release(lease, examined).has_value());
    EXPECT_GE(examined, facts / 100);
    EXPECT_EQ(board_.store().size(), 0U);
    EXPECT_FALSE(board_.renew(lease).has_value());
  }
}

TEST_F(LapsingBoard, WhatLapsedIsNotSeenByTheNextRequest) {
  for (int i = 0; i < 50; ++i) {
    const LeaseId brief = board_.lease(1s).value();
    Transaction one;
    one.tell(list("note"_sym, i), {}, brief);
    ASSERT_TRUE(board_.transact("alice", one).has_value());
    bool passed = false;
    executor_.call_at(executor_.now() + 999ms, [&] { passed = true; });
    executor_.run_until([&] { return passed; });
  }
  EXPECT_LE(board_.ask(query("(note ?n)"))->answers.size(), 2U);
}

}  // namespace
}  // namespace pizarra
