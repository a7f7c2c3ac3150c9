// The board's own names, which nobody else may use.

#include "blackboard/limits.hpp"
#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

using BoardOwn = BoardTest;

Relation named(const std::string& name, const std::string& argument = "text") {
  return {.name = name,
          .arguments = {{argument, ArgumentType::datum}},
          .key = {0},
          .durable = false,
          .lease = std::nullopt};
}

TEST_P(BoardOwn, WhatItSaysOfItselfCanBeAskedForAndNothingElse) {
  for (const char* pattern : {"(relation-stats ?a ?b ?c ?d ?e ?f ?g)", "(reader-stats ?a ?b ?c)",
                              "(journey-stats ?a ?b ?c)", "(watcher-stats ?a ?b ?c ?d)", "(client-stats ?a ?b ?c ?d)",
                              "(own-permission ?a ?b)"}) {
    const Datum form = read(pattern);
    EXPECT_EQ(symbol_of(wall->run(bob->ask(query(pattern)))), "ok") << pattern;
    const auto watched = wall->run(bob->watch(query(pattern)));
    ASSERT_EQ(symbol_of(watched), "not-permitted") << pattern;
    EXPECT_NE(watched.error().sentence.find("can be asked for"), std::string::npos) << watched.error().sentence;
    EXPECT_EQ(symbol_of(wall->run(bob->retract(form))), "not-permitted") << pattern;
    EXPECT_EQ(symbol_of(wall->run(bob->take(form, 0))), "not-permitted") << pattern;
    EXPECT_EQ(symbol_of(wall->run(bob->tell(list(form[0], 1)))), "not-permitted") << pattern;
    const std::vector<Relation> claimed = {named(std::string(form.head()))};
    EXPECT_EQ(symbol_of(wall->run(bob->declare(claimed))), "not-permitted") << pattern;
  }
}

TEST_P(BoardOwn, ANameHasABound) {
  const std::string longest(limits::name_bytes, 'n');
  const auto declared = [&](Relation relation) {
    const std::vector<Relation> relations = {std::move(relation)};
    return wall->run(bob->declare(relations));
  };
  EXPECT_EQ(symbol_of(declared(named(longest, longest))), "ok");
  for (const Relation& endless : {named(longest + "n"), named("endless", longest + "n")}) {
    const Result<void> refused = declared(endless);
    ASSERT_EQ(symbol_of(refused), "too-large");
    EXPECT_NE(refused.error().sentence.find("at most 128 bytes"), std::string::npos) << refused.error().sentence;
  }
  EXPECT_EQ(symbol_of(wall->run(bob->tell(list(Datum::symbol(longest), 1)))), "ok");
}

// A fault is told in a sentence that can be read.
TEST_P(BoardOwn, ANameOfAnyLengthThatIsNoRelationIsRefusedInFewWords) {
  const std::string endless(500'000, 'n');
  const Result<Revision> told = wall->run(bob->tell(list(Datum::symbol(endless), 1)));
  ASSERT_EQ(symbol_of(told), "undeclared-relation");
  EXPECT_LT(told.error().sentence.size(), 200U);
}

INSTANTIATE_TEST_SUITE_P(Walls, BoardOwn, testing::ValuesIn(all_walls()), wall_name);

}  // namespace
}  // namespace pizarra
