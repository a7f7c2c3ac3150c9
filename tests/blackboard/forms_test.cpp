#include <gtest/gtest.h>

#include "blackboard/stream.hpp"
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
