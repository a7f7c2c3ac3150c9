// The board's own names, which nobody else may use.

#include <fmt/format.h>

#include "blackboard/limits.hpp"
#include "lisp/writer.hpp"
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
                              "(own-permission ?a ?b)", "(provenance 1 ?a ?b ?c ?d ?e)"}) {
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

TEST_P(BoardOwn, AFactsReasonsAndTheirsAreOneQuestion) {
  const auto told = [&](const std::string& fact, const std::vector<FactId>& because) {
    EXPECT_TRUE(wall->run(bob->tell(read(fact), because)).has_value());
    return ask(*bob, fact).front().facts.front().id;
  };
  const FactId first = told("(on a b)", {});
  const FactId gone = told("(on b c)", {});
  const FactId middle = told("(on c d)", {first, gone});
  const FactId root = told("(on d e)", {middle, first});
  told("(on e f)", {root});
  ASSERT_TRUE(wall->run(bob->retract(read("(on b c)"))).has_value());
  const std::vector<Answer> answers =
      ask(*alice, fmt::format("(provenance {} ?id ?fact ?teller ?when ?because)", root));
  ASSERT_EQ(answers.size(), 3U) << "what has gone and what was told because of it are none of them";
  EXPECT_EQ(answers[0].facts.front().datum.items()[2], to_datum(root));
  EXPECT_EQ(*answers[0].bindings.find("?because"), list(middle, first));
  EXPECT_EQ(*answers[1].bindings.find("?fact"), read("(on c d)"));
  EXPECT_EQ(*answers[1].bindings.find("?because"), list(first, gone));
  EXPECT_EQ(*answers[2].bindings.find("?fact"), read("(on a b)"));
  EXPECT_EQ(*answers[2].bindings.find("?teller"), Datum::string("bob"));
  EXPECT_TRUE(ask(*alice, "(provenance 4000 ?id ?fact ?teller ?when ?because)").empty());
  const char* const without_root = "(provenance ?root ?id ?fact ?teller ?when ?because)";
  EXPECT_EQ(symbol_of(wall->run(bob->ask(query(without_root)))), "bad-query");
}

TEST_P(BoardOwn, ReasonsBeyondTheBoundAreLeftOut) {
  FactId before = 0;
  for (int n = 0; n < 300; ++n) {
    const std::vector<FactId> because = n == 0 ? std::vector<FactId>() : std::vector<FactId>{before};
    const Datum fact = list("on"_sym, "a"_sym, Datum::symbol(fmt::format("n{}", n)));
    ASSERT_TRUE(wall->run(bob->tell(fact, because)).has_value());
    before = ask(*bob, write(fact)).front().facts.front().id;
  }
  EXPECT_EQ(ask(*bob, fmt::format("(provenance {} ?id ?fact ?teller ?when ?because)", before)).size(), 200U);
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
