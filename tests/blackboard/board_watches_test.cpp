#include "blackboard/limits.hpp"
#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

using BoardWatches = BoardTest;

TEST_P(BoardWatches, TheFirstChangeIsWhatHoldsNow) {
  tell(*alice, "(on a b)");
  const std::unique_ptr<Watch> seen = watch(*bob, "(on ?x ?y)");
  const Change first = next(*seen);
  EXPECT_TRUE(first.resynchronised);
  EXPECT_EQ(values(first.added, "?x"), std::vector<Datum>{"a"_sym});
  EXPECT_TRUE(first.removed.empty());
  const std::unique_ptr<Watch> nothing = watch(*bob, "(mode ?m)");
  EXPECT_TRUE(next(*nothing).resynchronised);
}

TEST_P(BoardWatches, EveryChangeComesOnceInOrderWithItsRevision) {
  const std::unique_ptr<Watch> seen = watch(*bob, "(seen ?n ?x ?y)");
  next(*seen);
  std::vector<Revision> revisions;
  for (int i = 0; i < 50; ++i) {
    revisions.push_back(tell(*alice, "(seen \"circle\" " + std::to_string(i) + " 0)").value());
    tell(*alice, "(on a b" + std::to_string(i) + ")");
  }
  for (int i = 0; i < 50; ++i) {
    const Change change = next(*seen);
    EXPECT_EQ(change.revision, revisions[static_cast<std::size_t>(i)]);
    EXPECT_FALSE(change.resynchronised);
    EXPECT_EQ(values(change.added, "?x"), std::vector<Datum>{to_datum(i)});
    EXPECT_EQ(change.removed.size(), i > 0 ? 1U : 0U);
  }
}

TEST_P(BoardWatches, OneTransactionIsOneChangeOfItsNetEffect) {
  tell(*alice, "(on a b)");
  const std::unique_ptr<Watch> seen = watch(*bob, "(on ?x ?y)");
  next(*seen);
  Transaction steps;
  steps.tell(read("(on p q)")).retract(read("(on p q)")).retract(read("(on a b)")).tell(read("(on a c)"));
  const Result<Revision> revision = transact(*alice, steps);
  const Change change = next(*seen);
  EXPECT_EQ(change.revision, *revision);
  EXPECT_EQ(values(change.added, "?y"), std::vector<Datum>{"c"_sym});
  EXPECT_EQ(values(change.removed, "?y"), std::vector<Datum>{"b"_sym});
}

TEST_P(BoardWatches, AConjunctionIsWatchedAsAWhole) {
  const std::unique_ptr<Watch> clear = watch(*bob, "(and (on ?x ?y) (not (on ?z ?x)))");
  EXPECT_TRUE(next(*clear).added.empty());
  tell(*alice, "(on a b)");
  EXPECT_EQ(values(next(*clear).added, "?x"), std::vector<Datum>{"a"_sym});
  tell(*alice, "(on c a)");
  const Change covered = next(*clear);
  EXPECT_EQ(values(covered.removed, "?x"), std::vector<Datum>{"a"_sym});
  EXPECT_EQ(values(covered.added, "?x"), std::vector<Datum>{"c"_sym});
}

TEST_P(BoardWatches, AWatchOfOneKeyDoesNotHearOfOthers) {
  const std::unique_ptr<Watch> circle = watch(*bob, "(and (seen \"circle\" ?x ?y) (> ?x 5))");
  next(*circle);
  tell(*alice, "(seen \"cross\" 9 0)");
  tell(*alice, "(seen \"circle\" 1 0)");
  const Result<Revision> told = tell(*alice, "(seen \"circle\" 8 0)");
  const Change change = next(*circle);
  EXPECT_EQ(change.revision, *told);
  EXPECT_EQ(change.added.size(), 1U);
  EXPECT_TRUE(change.removed.empty());
}

TEST_P(BoardWatches, ALimitedWatchHearsWhatEntersAndLeavesTheLimit) {
  const std::unique_ptr<Watch> best = watch(*bob, "(query (seen ?n ?x ?y) (order (down ?x)) (limit 1))");
  next(*best);
  tell(*alice, "(seen \"low\" 1 0)");
  EXPECT_EQ(values(next(*best).added, "?n"), std::vector<Datum>{to_datum("low")});
  tell(*alice, "(seen \"high\" 5 0)");
  const Change change = next(*best);
  EXPECT_EQ(values(change.added, "?n"), std::vector<Datum>{to_datum("high")});
  EXPECT_EQ(values(change.removed, "?n"), std::vector<Datum>{to_datum("low")});
}

TEST_P(BoardWatches, AReaderThatLagsIsResynchronisedAndThenHearsEverything) {
  const std::unique_ptr<Watch> seen = watch(*bob, "(note ?n ?text)");
  next(*seen);
  const std::size_t many = 3 * limits::pending_changes;
  for (std::size_t i = 0; i < many; ++i) {
    ASSERT_TRUE(wall->run(alice->tell(list("note"_sym, i % 7, i))).has_value());
  }
  std::map<Datum, Datum> known;
  bool resynchronised = false;
  for (Revision revision = 0; revision < many;) {
    const Change change = next(*seen);
    ASSERT_GE(change.revision, revision) << "revisions never go back";
    if (change.resynchronised) known.clear();
    resynchronised = resynchronised || change.resynchronised;
    if (!change.resynchronised) {
      ASSERT_EQ(change.revision, revision + 1) << "no gap";
    }
    for (const Answer& answer : change.removed) ASSERT_EQ(known.erase(*answer.bindings.find("?n")), 1U);
    for (const Answer& answer : change.added) known[*answer.bindings.find("?n")] = *answer.bindings.find("?text");
    revision = change.revision;
  }
  EXPECT_TRUE(resynchronised);
  ASSERT_EQ(known.size(), 7U);
  for (const Answer& answer : ask(*alice, "(note ?n ?text)")) {
    EXPECT_EQ(known[*answer.bindings.find("?n")], *answer.bindings.find("?text"));
  }
}

TEST_P(BoardWatches, AReaderWhoseChangesAreTooHeavyIsResynchronised) {
  const std::unique_ptr<Watch> seen = watch(*bob, "(note ?n ?text)");
  next(*seen);
  // More than waits for a reader, besides what is under way to it.
  constexpr std::size_t heavy = 100'000;
  constexpr std::size_t many = 2 * limits::pending_bytes / heavy;
  for (std::size_t i = 1; i <= many; ++i) {
    ASSERT_TRUE(wall->run(alice->tell(list("note"_sym, 0, std::string(heavy + i, 'x')))).has_value());
  }
  bool resynchronised = false;
  for (std::size_t size = 0; size < heavy + many;) {
    const Change change = next(*seen);
    resynchronised = resynchronised || change.resynchronised;
    size = change.added.at(0).bindings.find("?text")->text().size();
  }
  EXPECT_TRUE(resynchronised);
}

TEST_P(BoardWatches, WhatHoldsComesWholeHoweverMuchItIsAndWhateverChangesMeanwhile) {
  const std::size_t many = 3000;
  const auto tell_all = [&](std::size_t first, std::size_t last) {
    Transaction facts;
    for (std::size_t n = first; n < last; ++n) facts.tell(list("note"_sym, n, std::string(1000, 'x')));
    ASSERT_EQ(symbol_of(transact(*alice, facts)), "ok");
  };
  for (std::size_t n = 0; n < many; n += 250) tell_all(n, n + 250);
  const std::unique_ptr<Watch> seen = watch(*bob, "(note ?n ?text)");
  for (std::size_t n = 0; n < many; n += 300) {
    Transaction changes;
    changes.retract(list("note"_sym, n, "?"_sym)).tell(list("note"_sym, n + 1, "anew"_sym));
    ASSERT_EQ(symbol_of(transact(*alice, changes)), "ok");
  }
  std::map<Datum, Datum> known;
  for (Revision revision = 0; revision < many / 250 + many / 300;) {
    const Change change = next(*seen);
    if (change.resynchronised) known.clear();
    for (const Answer& answer : change.removed) ASSERT_EQ(known.erase(*answer.bindings.find("?n")), 1U);
    for (const Answer& answer : change.added) known[*answer.bindings.find("?n")] = *answer.bindings.find("?text");
    revision = change.revision;
  }
  EXPECT_EQ(known.size(), many - many / 300);
  EXPECT_FALSE(known.contains(to_datum(300)));
  EXPECT_EQ(known.at(to_datum(301)), "anew"_sym);
}

TEST_P(BoardWatches, AnEndedWatchLeavesOthersAlone) {
  std::unique_ptr<Watch> ended = watch(*bob, "(on ?x ?y)");
  const std::unique_ptr<Watch> other = watch(*bob, "(on ?x ?y)");
  next(*other);
  ended.reset();
  tell(*alice, "(on a b)");
  EXPECT_EQ(next(*other).added.size(), 1U);
}

TEST_P(BoardWatches, AWaitThatIsAbandonedLosesNothing) {
  const std::unique_ptr<Watch> seen = watch(*bob, "(on ?x ?y)");
  next(*seen);
  {
    const auto wait = [](Watch& w) -> Task<void> { co_await w.next(); };
    const Job abandoned = wall->executor().spawn(wait(*seen));
    wall->pass(10ms);
  }
  tell(*alice, "(on a b)");
  EXPECT_EQ(next(*seen).added.size(), 1U);
}

INSTANTIATE_TEST_SUITE_P(Walls, BoardWatches, testing::ValuesIn(all_walls()), wall_name);

}  // namespace
}  // namespace pizarra
