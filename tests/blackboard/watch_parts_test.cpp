// A new watch among many facts receives them a few thousand at a time, whatever is committed between.

#include <gtest/gtest.h>
#include <map>

#include "blackboard/limits.hpp"
#include "blackboard/store/store.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/watch/watch_table.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

class WatchParts : public testing::Test {
 protected:
  static constexpr int facts = 20'000;
  static constexpr int one_in = 700;  // fits

  WatchParts() {
    store_.on_commit([this](const store::Commit& commit) { watches_.committed(commit); });
    EXPECT_TRUE(store_.declare({relation("(relation note ((n integer) (what datum)) (key n))")}).has_value());
    for (int n = 0; n < facts; ++n) tell(n, n % one_in == 0 ? 1000 + n : n % 100);
  }
  void tell(int n, int what) { commit(Transaction().tell(list("note"_sym, n, what))); }
  void commit(const Transaction& transaction) {
    ASSERT_TRUE(store_.transact("alice", transaction, Time()).has_value());
  }
  // What a reader knows; nothing for certain before the last part.
  void take(Delta delta) {
    const bool first = delta.kind == Delta::Kind::all || delta.kind == Delta::Kind::first_part;
    if (first) known_.clear();
    for (const Fact& fact : delta.removed.facts) ASSERT_EQ(known_.erase(fact.id), 1U);
    for (const Fact& fact : delta.added.facts) ASSERT_TRUE(known_.emplace(fact.id, fact.datum).second);
    whole_ = first ? delta.kind == Delta::Kind::all : whole_ || delta.kind == Delta::Kind::last_part;
  }
  // As a server does it, so many facts a turn; answers whether more is to be looked for.
  bool turn(watch::WatchQueue& queue) {
    std::size_t examined = 0;
    while (queue.ready() && !(queue.must_look() && examined >= limits::examined_a_turn)) {
      std::optional<Delta> delta = queue.pop_delta(examined).value();
      if (delta) take(std::move(*delta));
    }
    EXPECT_LE(examined, limits::examined_a_turn + 1);
    return queue.must_look();
  }
  void compare() {
    std::map<FactId, Datum> all;
    const Result<Answers> answers = store_.ask(watched_);
    for (const Answer& answer : answers->answers) all.emplace(answer.facts[0].id, answer.facts[0].datum);
    ASSERT_TRUE(whole_);
    ASSERT_EQ(known_, all);
  }

  const Query watched_ = query("(and (note ?n ?what) (>= ?what 1000))");
  store::Store store_;
  watch::WatchTable watches_{store_};
  std::map<FactId, Datum> known_;
  bool whole_ = false;
};

TEST_F(WatchParts, AreLookedForAFewThousandFactsATurn) {
  const auto queue = watches_.add(watched_, nullptr).value();
  int turns = 0;
  while (turn(*queue)) ++turns;
  EXPECT_GE(turns, facts / static_cast<int>(limits::examined_a_turn) - 1);
  EXPECT_LE(turns, 2 * facts / static_cast<int>(limits::examined_a_turn));
  compare();
}

TEST_F(WatchParts, ComeWholeToWhoTakesThemWhole) {
  const auto queue = watches_.add(watched_, nullptr).value();
  const Change all = queue->pop().value();
  EXPECT_EQ(all.added.size(), facts / one_in + 1);
  EXPECT_FALSE(queue->ready());
}

TEST_F(WatchParts, AreTrueOfWhateverChangesBetweenTheTurns) {
  for (std::uint64_t seed = 1; seed <= 10; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const auto queue = watches_.add(watched_, nullptr).value();
    const auto any = [&] { return static_cast<int>(random.below(facts)); };
    const auto one_that_fits = [&] { return static_cast<int>(random.below(facts / one_in)) * one_in; };
    for (bool more = true; more; more = turn(*queue)) {
      for (int i = 0; i < 6; ++i) {
        tell(any(), 1000 + any());
        tell(one_that_fits(), any() % 2000);
        commit(Transaction().retract(list("note"_sym, one_that_fits(), "?"_sym)));
      }
      if (random.below(20) == 0) queue->resynchronise();
    }
    turn(*queue);
    compare();
  }
}

}  // namespace
}  // namespace pizarra
