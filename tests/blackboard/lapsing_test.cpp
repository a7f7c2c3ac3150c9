// How much goes with a lease before others are served.

#include <algorithm>

#include <gtest/gtest.h>

#include "blackboard/store/store.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

class Lapsing : public testing::Test {
 protected:
  static constexpr std::size_t at_once = 1000;
  static constexpr std::size_t facts = 2 * at_once + 500;

  Lapsing() {
    EXPECT_TRUE(store_.declare({relation("(relation note ((n integer)) (key n))"),
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

  Store store_;
  Time now_{};
  LeaseId lease_ = 0;
};

TEST_F(Lapsing, OfALeaseGoesInPartsAndTheLeaseAtOnce) {
  tell_all("note", lease_);
  now_ += 2s;
  expire();
  EXPECT_EQ(store_.size(), facts - at_once);
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

}  // namespace
}  // namespace pizarra
