#include "blackboard/store/index_maker.hpp"

#include <algorithm>
#include <gtest/gtest.h>

#include "blackboard/store/store.hpp"
#include "blackboard/time/random.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

class Indexes : public testing::Test {
 protected:
  static constexpr std::uint64_t facts = 3000;

  Indexes() {
    const Result<std::vector<Relation>> declared = store_.declare(
        {relation("(relation r ((k integer) (a integer) (b integer) (c integer) (d integer)) (key k))")});
    EXPECT_TRUE(declared.has_value());
    for (std::uint64_t k = 0; k < facts; ++k) tell(k);
  }
  void tell(std::uint64_t key) {
    const auto some = [&](std::uint64_t most) { return random_.below(most); };
    const Datum fact = list("r"_sym, key, some(5), some(50), some(500), some(facts));
    EXPECT_TRUE(store_.transact("test", Transaction().tell(fact), Time()).has_value());
  }
  void retract(std::uint64_t key) {
    const Datum pattern = list("r"_sym, key, "?"_sym, "?"_sym, "?"_sym, "?"_sym);
    EXPECT_TRUE(store_.transact("test", Transaction().retract(pattern), Time()).has_value());
  }
  void make_in_parts() {
    store_.index_maker().on_wanted = [this] { ++wanted_; };
  }
  // Nothing where an index is to be awaited.
  std::optional<std::vector<Answer>> ask(const Query& asked) {
    const store::Indexing indexing(store::Indexing::May::make_in_parts, &store_.index_maker());
    const Result<Answers> answers = store_.ask(asked);
    if (indexing.awaited() == 0) return answers.value().answers;
    EXPECT_EQ(answers.error().symbol, "awaits-index");
    return std::nullopt;
  }
  std::optional<std::vector<Answer>> ask(const std::string& asked) { return ask(query(asked)); }
  // By a store whose indexes are made whole when all facts stand.
  std::vector<Answer> found_anew(const Query& asked) {
    store::Store other;
    other.declare({store_.tables().begin()->second.relation()}).value();
    for (const store::StandingFact& standing : store_.tables().begin()->second.facts()) {
      EXPECT_TRUE(other.restore(standing.fact, store::Restored::standing).has_value());
    }
    return other.ask(asked).value().answers;
  }
  std::size_t looked_at(const std::string& asked) {
    std::size_t examined = 0;
    EXPECT_TRUE(store_.ask(query(asked), examined).has_value());
    return examined;
  }
  void make_all() {
    while (!store_.index_maker().is_idle()) store_.index_maker().make_some();
  }

  store::Store store_;
  Random random_{1};
  int wanted_ = 0;
};

TEST_F(Indexes, AQuestionThatNeedsALargeOneAwaitsIt) {
  make_in_parts();
  const std::string asked = "(r ?k 3 ? ? ?)";
  EXPECT_FALSE(ask(asked).has_value());
  EXPECT_EQ(wanted_, 1);
  std::size_t parts = 0;
  for (; !store_.index_maker().is_idle(); ++parts) {
    EXPECT_FALSE(ask(asked).has_value());
    EXPECT_LE(store_.index_maker().make_some(), limits::examined_a_turn + store::Indexing::looks_a_fact);
  }
  EXPECT_GE(parts, facts * store::Indexing::looks_a_fact / limits::examined_a_turn);
  EXPECT_EQ(wanted_, 1);
  EXPECT_EQ(ask(asked), found_anew(query(asked)));
  EXPECT_LT(looked_at(asked), facts / 3);
}

TEST_F(Indexes, EveryChangeMeanwhileIsInIt) {
  make_in_parts();
  std::vector<Query> all;
  for (const std::string asked :
       {"(r ?k 3 ? ? ?)", "(r ?k ? 17 ? ?)", "(and (r ?k 1 ?b ? ?) (r ?j 2 ?b 7 ?))", "(and (r ?k ? ? ?c ?) (< ?c 9))",
        "(query (r ?k ? ? ? ?d) (order (down ?d)) (limit 4))", "(and (r ?k 4 ? ? ?d) (not (r ? 3 ? ? ?d)))"}) {
    all.push_back(query(asked));
  }
  int answered = 0;
  for (int step = 0; step < 600; ++step) {
    for (int change = 0; change < 4; ++change) {
      const std::uint64_t key = random_.below(facts + 500);
      if (random_.below(3) == 0) {
        retract(key);
      } else {
        tell(key);
      }
    }
    if (!store_.index_maker().is_idle()) store_.index_maker().make_some();
    const Query& asked = all[random_.below(all.size())];
    const auto answers = ask(asked);
    if (!answers) continue;
    ++answered;
    ASSERT_EQ(*answers, found_anew(asked)) << pizarra::write(query_to_datum(asked));
  }
  EXPECT_GT(answered, 100);
}

TEST_F(Indexes, WhatAwaitsOneChangesNothing) {
  make_in_parts();
  const Revision before = store_.revision();
  const auto await = [&](const auto& act) {
    const store::Indexing indexing(store::Indexing::May::make_in_parts, &store_.index_maker());
    const auto result = act();
    EXPECT_EQ(result.error().symbol, "awaits-index");
    EXPECT_NE(indexing.awaited(), 0U);
  };
  await([&] { return store_.take("test", read("(r ? 3 ? ? ?)"), 0, Time()); });
  await([&] { return store_.transact("test", Transaction().retract(read("(r ? 3 ? ? ?)")), Time()); });
  const Transaction::Absent none{read("(r ? ? 51 ? ?)")};
  await([&] { return store_.transact("test", Transaction().tell(read("(r 9000 1 1 1 1)")).require(none), Time()); });
  EXPECT_EQ(store_.revision(), before);
}

TEST_F(Indexes, SeveralAreMadeInTurnAndWhoAwaitsOneIsToldWhenAnyIsMade) {
  make_in_parts();
  EXPECT_FALSE(ask("(r ?k 3 ? ? ?)"));
  const store::IndexTicket awaited = store_.index_maker().made() + 1;
  EXPECT_FALSE(ask("(r ?k ? 3 ? ?)"));
  EXPECT_EQ(wanted_, 2);
  while (store_.index_maker().is_awaited(awaited)) store_.index_maker().make_some();
  EXPECT_FALSE(store_.index_maker().is_idle());
  EXPECT_TRUE(ask("(r ?k 3 ? ? ?)"));
  EXPECT_FALSE(ask("(r ?k ? 3 ? ?)"));
  make_all();
  EXPECT_TRUE(ask("(r ?k ? 3 ? ?)"));
}

TEST_F(Indexes, OneThatIsBegunIsMadeByTheMakerAloneHoweverFewFactsAreLeft) {
  make_in_parts();
  const std::string begun = "(r ?k 3 ? ? ?)";
  EXPECT_FALSE(ask(begun));
  for (std::uint64_t key = 300; key < facts; ++key) retract(key);
  EXPECT_FALSE(ask(begun));
  const std::vector<std::string> others = {"(r ?k ? 1 ? ?)", "(r ?k ? ? 1 ?)", "(r ?k ? ? ? 1)", "(r ?k 1 1 ? ?)",
                                           "(r ?k 1 ? 1 ?)", "(r ?k 1 ? ? 1)", "(r ?k ? 1 1 ?)"};
  for (const std::string& other : others) EXPECT_TRUE(ask(other));
  for (int times = 0; times < 40; ++times) EXPECT_EQ(ask("(r ?k ? ? 1 1)"), found_anew(query("(r ?k ? ? 1 1)")));
  EXPECT_FALSE(store_.index_maker().is_idle());
  make_all();
  EXPECT_EQ(ask(begun), found_anew(query(begun)));
}

TEST_F(Indexes, WhoeverAsksAndWhateverComesAndGoesMeanwhileTheAnswersAreRight) {
  make_in_parts();
  std::vector<Query> all;
  for (int bound = 1; bound < 16; ++bound) {
    const auto value = [&](int which) { return (bound >> which & 1) != 0 ? "1" : "?"; };
    std::string pattern = "(r ?k";
    for (int which = 0; which < 4; ++which) pattern += std::string(" ") + value(which);
    all.push_back(query(pattern + ")"));
  }
  for (const std::string asked : {"(< ?a 1)", "(< ?b 3)", "(< ?c 9)", "(< ?d 9)", "(< ?k 9)"}) {
    all.push_back(query("(and (r ?k ?a ?b ?c ?d) " + asked + ")"));
  }
  int answered = 0;
  int awaited = 0;
  bool filling = false;
  for (int step = 0; step < 4000; ++step) {
    // From few to many and back: what is made at once and what is made in parts take turns.
    if (random_.below(200) == 0) filling = !filling;
    for (int change = 0; change < 40; ++change) {
      const std::uint64_t key = random_.below(facts);
      if (filling == (random_.below(6) > 0)) {
        tell(key);
      } else {
        retract(key);
      }
    }
    if (!store_.index_maker().is_idle() && random_.below(50) == 0) store_.index_maker().make_some();
    const Query& asked = all[random_.below(all.size())];
    const auto answers = ask(asked);
    ++(answers ? answered : awaited);
    if (!answers || random_.below(10) != 0) continue;
    ASSERT_EQ(*answers, found_anew(asked)) << pizarra::write(query_to_datum(asked));
  }
  EXPECT_GT(answered, 1000);
  EXPECT_GT(awaited, 100);
}

// Nine kinds of questions, and eight indexes.
TEST_F(Indexes, OneThatWasNotUsedForLongGoesForAnother) {
  const std::vector<std::string> kinds = {"(r ?k 1 ? ? ?)", "(r ?k ? 1 ? ?)", "(r ?k ? ? 1 ?)", "(r ?k ? ? ? 1)",
                                          "(r ?k 1 1 ? ?)", "(r ?k 1 ? 1 ?)", "(r ?k 1 ? ? 1)", "(r ?k ? 1 1 ?)"};
  const std::string& least = kinds[4];
  for (const std::string& kind : kinds) EXPECT_LT(looked_at(kind), facts / 3) << kind;
  const std::string ninth = "(r ?k ? ? 1 1)";
  const std::size_t without = looked_at(ninth);
  EXPECT_GE(without, 3U) << "all eight were just used";
  for (int times = 0; times < 100; ++times) {
    for (const std::string& kind : kinds) {
      if (kind != least) looked_at(kind);
    }
  }
  looked_at(ninth);
  EXPECT_LT(looked_at(ninth), 3U);
  const std::size_t by_another = looked_at(least);
  EXPECT_GT(by_another, 50U) << "its own is gone";
  for (const std::string& kind : kinds) {
    if (kind == least) continue;
    EXPECT_EQ(looked_at(kind), std::max(found_anew(query(kind)).size(), std::size_t{1})) << kind;
  }
  retract(5);
  tell(6);
  EXPECT_EQ(store_.ask(query(least)).value().answers, found_anew(query(least)));
}

TEST_F(Indexes, OneThatIsMadeInPartsTakesThePlaceOfTheLeastLatelyUsed) {
  make_in_parts();
  const auto found = [&](const std::string& asked) {
    for (int times = 0; times < 1'000'000; ++times) {
      const auto answers = ask(asked);
      make_all();
      if (answers) return *answers;
    }
    return std::vector<Answer>();
  };
  for (const std::string asked : {"(< ?a 1)", "(< ?b 1)", "(< ?c 1)", "(< ?d 1)"}) {
    found("(and (r ?k ?a ?b ?c ?d) " + asked + ")");
  }
  const std::string fifth = "(and (r ?k ?a ?b ?c ?d) (< ?k 20))";
  EXPECT_EQ(looked_at(fifth), facts);
  for (int times = 0; times < 200; ++times) EXPECT_EQ(found(fifth), found_anew(query(fifth)));
  EXPECT_LT(looked_at(fifth), 100U);
  for (std::uint64_t key = 0; key < 200; ++key) tell(key);
  EXPECT_EQ(found(fifth), found_anew(query(fifth)));
}

}  // namespace
}  // namespace pizarra
