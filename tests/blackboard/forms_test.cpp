#include <gtest/gtest.h>

#include "blackboard/stream.hpp"
#include "blackboard/wire/answer_form.hpp"
#include "tests/blackboard/wall.hpp"

namespace pizarra {
namespace {

TEST(RelationForm, SurvivesTheWayToDataAndBack) {
  for (const char* text : {"(relation seen ((name string) (x number) (y number)) (key name))",
                           "(relation on ((a symbol) (b symbol)))", "(relation mode ((m symbol)) (key) (durable))",
                           "(relation alarm ((t list) (d datum)) (lease 5000))", "(relation nothing ())"}) {
    const Relation original = relation(text);
    EXPECT_EQ(relation_from_datum(relation_to_datum(original)), original) << text;
  }
  EXPECT_EQ(relation("(relation on ((a symbol) (b symbol)))").key, (std::vector<std::size_t>{0, 1}));
  EXPECT_TRUE(relation("(relation mode ((m symbol)) (key))").key.empty());
}

TEST(RelationForm, WhatIsNoRelationIsRefused) {
  for (const char* text :
       {"(relation)", "(relation x)", "(relation \"x\" ())", "(relation x (a))", "(relation x ((a color)))",
        "(relation x ((a symbol) (a symbol)))", "(relation x ((a symbol)) (key b))",
        "(relation x ((a symbol)) (key a a))", "(relation x () (lease 0))", "(relation x () (lease soon))",
        "(relation x () (forever))", "(relation and ((a symbol)))", "(relation ?x ((a symbol)))",
        "(relation x ((?a symbol)))", "word"}) {
    EXPECT_FALSE(relation_from_datum(read(text)).has_value()) << text;
  }
}

TEST(QueryForm, SurvivesTheWayToDataAndBack) {
  for (const char* text :
       {"(on ?x ?y)", "(and (on ?x ?y) (not (on ?z ?x)) (/= ?x ?y))", "(not (mode idle))",
        "(query (seen ?n ?x) (order ?x))", "(query (and (on ?x ?y) (on ?y ?z)) (order (down ?x)) (limit 3))",
        "(query (on ?x ?y) (limit 0))"}) {
    EXPECT_EQ(query_to_datum(query(text)), read(text)) << text;
  }
}

Fact fact_told(FactId id, Revision revision, std::string teller, Duration when, std::vector<FactId> because = {}) {
  return {.datum = list("n"_sym, id),
          .id = id,
          .teller = std::move(teller),
          .when = Time(when),
          .revision = revision,
          .because = std::move(because)};
}

Delta change_by_several() {
  Delta change;
  change.revision = 9;
  change.added.facts = {fact_told(1, 7, "alice", 5ms),      fact_told(2, 7, "alice", 5ms, {1}),
                        fact_told(3, 8, "alice", 5ms),      fact_told(4, 8, "bob \"the builder\"", 5ms),
                        fact_told(5, 8, "alice", 5ms, {2}), fact_told(6, 8, "alice", 6ms)};
  change.added.answers = change.added.facts.size();
  return change;
}

TEST(ChangeForm, SaysOnceWhenAndByWhomFactsWereToldToWhoKeepsThem) {
  Delta change = change_by_several();
  change.removed.facts = {fact_told(7, 8, "alice", 6ms)};
  change.removed.answers = 1;
  std::string text;
  wire::write_change(text, 3, 4, 1, true, change);
  EXPECT_EQ(text,
            "(change 3 4 9 no ((1 7 5000 \"alice\" (n 1))(2 (n 2) 1)(3 8 5000 \"alice\" (n 3))"
            "(4 8 5000 \"bob \\\"the builder\\\"\" (n 4))(5 8 5000 \"alice\" (n 5) 2)"
            "(6 8 6000 \"alice\" (n 6))) (7 ))");
  const Result<Delta> read_back = wire::delta_from_datum(query("(n ?id)"), true, read(text));
  ASSERT_TRUE(read_back.has_value()) << text;
  EXPECT_EQ(read_back->added.facts, change.added.facts);
  ASSERT_EQ(read_back->removed.facts.size(), 1U);
  EXPECT_EQ(read_back->removed.facts[0].id, 7U);
}

TEST(ChangeForm, WithAFactThatIsNoneIsRefused) {
  for (const char* added :
       {"((n 1))", "((2 (n 2)))", "((1 7 5 \"a\" (n 1)) (2 (n 2) x))", "((1 7 5 \"a\" (n 1)) (0 (n 2)))",
        "((1 7 5 \"a\" (n 1)) (2))", "(x)", "x", "(0)", "(1)", "((1 7 5 \"a\" (n 1)) 2)"}) {
    const std::string text = std::string("(change 3 4 9 no ") + added + " ())";
    const Result<Delta> refused = wire::delta_from_datum(query("(n ?id)"), true, read(text));
    ASSERT_FALSE(refused.has_value()) << text;
    EXPECT_EQ(refused.error().symbol, "bad-frame") << text;
  }
}

TEST(ChangeForm, WithAFactGoneThatIsNoNumberIsRefused) {
  for (const char* removed : {"(x)", "(-1)", "((1 7 5 \"a\" (n 1)))", "x"}) {
    const std::string text = std::string("(change 3 4 9 no () ") + removed + ")";
    const Result<Delta> refused = wire::delta_from_datum(query("(n ?id)"), true, read(text));
    ASSERT_FALSE(refused.has_value()) << text;
    EXPECT_EQ(refused.error().symbol, "bad-frame") << text;
  }
}

TEST(ChangeForm, SurvivesTheWayToTextAndBackWhoeverToldItsFacts) {
  Delta change = change_by_several();
  change.removed.facts = {fact_told(7, 8, "alice", 6ms)};
  change.removed.answers = 1;
  std::string text;
  wire::write_change(text, 3, 4, 1, false, change);
  const Result<Delta> read_back = wire::delta_from_datum(query("(n ?id)"), false, read(text));
  ASSERT_TRUE(read_back.has_value()) << text;
  EXPECT_EQ(read_back->revision, 9U);
  EXPECT_EQ(read_back->added.facts, change.added.facts) << text;
  EXPECT_EQ(read_back->removed.facts, change.removed.facts) << text;
}

TEST(LocalStreams, TheFramesOfAStreamReachItsSubscribers) {
  LocalStreams streams;
  std::vector<std::uint64_t> left;
  EXPECT_FALSE(streams.watched("left"));
  auto subscription = streams.subscribe("left", [&](const StreamFrame& frame) { left.push_back(frame.number); });
  EXPECT_TRUE(streams.watched("left"));
  EXPECT_FALSE(streams.watched("right"));
  streams.publish("left", {1, Time(), nullptr});
  streams.publish("right", {2, Time(), nullptr});
  subscription.reset();
  streams.publish("left", {3, Time(), nullptr});
  EXPECT_EQ(left, std::vector<std::uint64_t>{1});
  EXPECT_FALSE(streams.watched("left"));
}

TEST(LocalStreams, AReceiverMayEndAnySubscription) {
  LocalStreams streams;
  int second_received = 0;
  std::unique_ptr<Streams::Subscription> first;
  std::unique_ptr<Streams::Subscription> second;
  first = streams.subscribe("left", [&](const StreamFrame&) {
    first.reset();
    second.reset();
  });
  second = streams.subscribe("left", [&](const StreamFrame&) { ++second_received; });
  streams.publish("left", {1, Time(), nullptr});
  EXPECT_EQ(second_received, 0);
  EXPECT_FALSE(streams.watched("left"));
}

}  // namespace
}  // namespace pizarra
