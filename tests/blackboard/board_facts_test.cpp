#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

using BoardFacts = BoardTest;

TEST_P(BoardFacts, AFactToldByOneIsFoundByAnother) {
  const Result<Revision> revision = tell(*alice, "(seen \"circle\" 112.25 87)");
  ASSERT_TRUE(revision.has_value());
  const Result<std::vector<Fact>> facts = wall->run(bob->facts(read("(seen ?name ?x ?y)")));
  ASSERT_TRUE(facts.has_value());
  ASSERT_EQ(facts->size(), 1U);
  EXPECT_EQ(facts->front().datum, read("(seen \"circle\" 112.25 87)"));
  EXPECT_EQ(facts->front().teller, "alice");
  EXPECT_EQ(facts->front().revision, *revision);
  EXPECT_GT(facts->front().id, 0U);
  EXPECT_LE(facts->front().when, wall->executor().now());
}

TEST_P(BoardFacts, AFactRemembersWhatItWasToldBecauseOf) {
  tell(*alice, "(seen \"circle\" 1 2)");
  const FactId cause = ask(*alice, "(seen ?n ?x ?y)").front().facts.front().id;
  const std::vector<FactId> because = {cause};
  ASSERT_TRUE(wall->run(bob->tell(read("(on circle square)"), because)).has_value());
  EXPECT_EQ(ask(*alice, "(on ?x ?y)").front().facts.front().because, because);
}

TEST_P(BoardFacts, TellingReplacesTheFactWithTheSameKeyAndNoOther) {
  tell(*alice, "(seen \"circle\" 1 2)");
  tell(*alice, "(seen \"cross\" 3 4)");
  tell(*bob, "(seen \"circle\" 5 6)");
  EXPECT_EQ(values(ask(*bob, "(seen \"circle\" ?x ?y)"), "?x"), std::vector<Datum>{to_datum(5)});
  EXPECT_EQ(values(ask(*bob, "(seen \"cross\" ?x ?y)"), "?x"), std::vector<Datum>{to_datum(3)});
}

TEST_P(BoardFacts, AnEmptyKeyHoldsOneFactAndNoKeyHoldsEveryFact) {
  tell(*alice, "(mode idle)");
  tell(*alice, "(mode tracking)");
  EXPECT_EQ(values(ask(*bob, "(mode ?m)"), "?m"), std::vector<Datum>{"tracking"_sym});
  tell(*alice, "(on a b)");
  tell(*alice, "(on a c)");
  EXPECT_EQ(ask(*bob, "(on a ?y)").size(), 2U);
}

TEST_P(BoardFacts, TellingWhatStandsChangesNothing) {
  const Result<Revision> first = tell(*alice, "(on a b)");
  const Fact before = ask(*alice, "(on a b)").front().facts.front();
  EXPECT_EQ(tell(*bob, "(on a b)"), first);
  EXPECT_EQ(ask(*alice, "(on a b)").front().facts.front(), before);
}

TEST_P(BoardFacts, RevisionsGrowByOneForEveryChangeAndIdsAreNeverUsedAgain) {
  const Revision first = tell(*alice, "(on a b)").value();
  const FactId id = ask(*alice, "(on a b)").front().facts.front().id;
  EXPECT_EQ(wall->run(bob->retract(read("(on a ?)"))), first + 1);
  EXPECT_EQ(wall->run(bob->retract(read("(on a ?)"))), first + 1);
  EXPECT_EQ(tell(*alice, "(on a b)"), first + 2);
  EXPECT_GT(ask(*alice, "(on a b)").front().facts.front().id, id);
}

TEST_P(BoardFacts, RetractTakesAwayEveryFactThatFits) {
  for (const char* fact : {"(on a b)", "(on a c)", "(on d c)"}) tell(*alice, fact);
  ASSERT_TRUE(wall->run(bob->retract(read("(on a ?)"))).has_value());
  EXPECT_EQ(values(ask(*alice, "(on ?x ?y)"), "?x"), std::vector<Datum>{"d"_sym});
}

TEST_P(BoardFacts, AnUndeclaredRelationIsRefusedWithTheNearestName) {
  const Result<Revision> told = tell(*alice, "(sen \"circle\" 1 2)");
  ASSERT_EQ(symbol_of(told), "undeclared-relation");
  EXPECT_NE(told.error().sentence.find("seen"), std::string::npos) << told.error().sentence;
  EXPECT_EQ(symbol_of(wall->run(alice->ask(query("(sen ?n ?x ?y)")))), "undeclared-relation");
  EXPECT_EQ(symbol_of(wall->run(alice->watch(query("(sen ?n ?x ?y)")))), "undeclared-relation");
  EXPECT_EQ(symbol_of(wall->run(alice->take(read("(sen ?n ?x ?y)"), 0))), "undeclared-relation");
  EXPECT_EQ(symbol_of(wall->run(alice->retract(read("(sen ?n ?x ?y)")))), "undeclared-relation");
}

TEST_P(BoardFacts, AWrongShapeIsRefusedNamingTheArgument) {
  const Result<Revision> told = tell(*alice, "(seen \"circle\" 1 two)");
  ASSERT_EQ(symbol_of(told), "wrong-shape");
  EXPECT_NE(told.error().sentence.find("argument y of seen"), std::string::npos) << told.error().sentence;
  EXPECT_EQ(told.error().subject, read("(seen \"circle\" 1 two)"));
  for (const char* fact : {"(seen \"circle\" 1)", "(seen circle 1 2)", "(seen \"circle\" ?x 2)", "(note 1 (a ?b))",
                           "(note 1.5 a)", "(on \"a\" b)"}) {
    EXPECT_EQ(symbol_of(tell(*alice, fact)), "wrong-shape") << fact;
  }
  EXPECT_EQ(symbol_of(wall->run(alice->tell("word"_sym))), "wrong-shape");
  EXPECT_EQ(symbol_of(wall->run(alice->ask(query("(seen circle ?x ?y)")))), "wrong-shape");
}

TEST_P(BoardFacts, DeclaringAgainIsHarmlessAndDifferentlyIsRefused) {
  EXPECT_EQ(symbol_of(wall->run(bob->declare(relations()))), "ok");
  const std::vector<Relation> other = {relation("(relation extra ((a symbol)))"),
                                       relation("(relation on ((upper symbol) (lower symbol)) (key upper))")};
  EXPECT_EQ(symbol_of(wall->run(bob->declare(other))), "wrong-shape");
  EXPECT_EQ(symbol_of(tell(*bob, "(extra a)")), "undeclared-relation") << "all or nothing";
}

TEST_P(BoardFacts, ATransactionHappensWholeOrNotAtAll) {
  tell(*alice, "(on a b)");
  Transaction bad;
  bad.retract(read("(on a b)")).tell(read("(on b c)")).tell(read("(seen wrong)"));
  EXPECT_EQ(symbol_of(transact(*alice, bad)), "wrong-shape");
  EXPECT_TRUE(holds(*bob, "(on a b)"));
  EXPECT_FALSE(holds(*bob, "(on b c)"));
}

TEST_P(BoardFacts, StepsHappenInTheirOrderAtOneRevision) {
  Transaction steps;
  steps.tell(read("(on a b)")).tell(read("(mode idle)")).retract(read("(on ? ?)")).tell(read("(mode ready)"));
  const Result<Revision> revision = transact(*alice, steps);
  ASSERT_TRUE(revision.has_value());
  EXPECT_FALSE(holds(*bob, "(on ? ?)"));
  EXPECT_EQ(ask(*bob, "(mode ready)").front().facts.front().revision, *revision);
}

TEST_P(BoardFacts, PreconditionsDecideWhetherATransactionHappens) {
  const Revision before = tell(*alice, "(on a b)").value();
  const auto attempt = [&](Transaction::Precondition precondition) {
    Transaction transaction;
    transaction.require(std::move(precondition)).tell(read("(mode done)"));
    std::string symbol = symbol_of(transact(*bob, transaction));
    EXPECT_EQ(holds(*bob, "(mode done)"), symbol == "ok");
    EXPECT_TRUE(wall->run(bob->retract(read("(mode ?)"))).has_value());
    return symbol;
  };
  EXPECT_EQ(attempt(Transaction::Present{read("(on a ?)")}), "ok");
  EXPECT_EQ(attempt(Transaction::Present{read("(on b ?)")}), "precondition-failed");
  EXPECT_EQ(attempt(Transaction::Absent{read("(on b ?)")}), "ok");
  EXPECT_EQ(attempt(Transaction::Absent{read("(on a ?)")}), "precondition-failed");
  EXPECT_EQ(attempt(Transaction::Absent{read("(of a ?)")}), "undeclared-relation");
  EXPECT_EQ(attempt(Transaction::Unchanged{read("(on a ?)"), before}), "ok");
  EXPECT_EQ(attempt(Transaction::Unchanged{read("(on a ?)"), before - 1}), "precondition-failed") << "told since";
  tell(*alice, "(on c d)");
  EXPECT_EQ(attempt(Transaction::Unchanged{read("(on a ?)"), before}), "ok") << "another fact is no matter";
  ASSERT_TRUE(wall->run(alice->retract(read("(on a b)"))).has_value());
  EXPECT_EQ(attempt(Transaction::Unchanged{read("(on a ?)"), before}), "precondition-failed") << "retracted since";
  EXPECT_EQ(attempt(Transaction::Unchanged{read("(on a ?)"), 1'000'000}), "precondition-failed")
      << "seen at a revision that has not been: on another board, or before this one began anew";
}

TEST_P(BoardFacts, WhatIsTooLargeIsRefusedAndTheBoardGoesOn) {
  EXPECT_EQ(symbol_of(wall->run(alice->tell(list("note"_sym, 1, std::string(2'000'000, 'x'))))), "too-large");
  Datum deep = list();
  for (int i = 0; i < 60; ++i) deep = list(deep);
  EXPECT_EQ(symbol_of(wall->run(alice->tell(list("note"_sym, 1, deep)))), "too-large");
  Transaction many;
  for (int i = 0; i < 10'001; ++i) many.tell(list("note"_sym, i, "x"_sym));
  EXPECT_EQ(symbol_of(transact(*alice, many)), "too-large");
  EXPECT_FALSE(holds(*alice, "(note ? ?)"));
}

// A retraction also looks at the facts that its own transaction has told before it.
TEST_P(BoardFacts, ATransactionThatLooksThroughWhatItTellsIsBounded) {
  constexpr int many = 600;
  Transaction costly;
  for (int i = 0; i < many; ++i) costly.tell(list("note"_sym, i, "x"_sym));
  for (int i = 0; i < many; ++i) costly.retract(read("(note ? (f ?x ?x))"));
  EXPECT_EQ(symbol_of(transact(*alice, costly)), "too-costly");
  EXPECT_FALSE(holds(*alice, "(note ? ?)"));
  Transaction indexed;
  for (int i = 0; i < many; ++i) {
    const Datum upper = Datum::symbol("b" + std::to_string(i));
    indexed.tell(list("on"_sym, upper, "x"_sym)).retract(list("on"_sym, upper, "?"_sym));
  }
  EXPECT_EQ(symbol_of(transact(*alice, indexed)), "ok");
  Transaction relations_apart;
  for (int i = 0; i < many; ++i) relations_apart.tell(list("note"_sym, i, "x"_sym));
  for (int i = 0; i < many; ++i) relations_apart.retract(read("(on ?x ?x)"));
  EXPECT_EQ(symbol_of(transact(*alice, relations_apart)), "ok");
}

TEST_P(BoardFacts, WhatATransactionTellsAndRetractsItselfIsNowhere) {
  const std::unique_ptr<Watch> watched = watch(*bob, "(note ?n ?)");
  next(*watched);
  Transaction steps;
  for (int i = 0; i < 9; ++i) steps.tell(list("note"_sym, i, "x"_sym));
  for (const int i : {4, 0, 8, 2}) steps.retract(list("note"_sym, i, "?"_sym));
  steps.tell(read("(note 2 y)")).tell(read("(note 3 y)")).retract(read("(note 3 ?)"));
  ASSERT_EQ(symbol_of(transact(*alice, steps)), "ok");
  EXPECT_EQ(values(next(*watched).added, "?n"),
            (std::vector<Datum>{to_datum(1), to_datum(5), to_datum(6), to_datum(7), to_datum(2)}));
}

// A string is as large as what is written of it.
TEST_P(BoardFacts, AFactMayTakeNearlyAWholeMessage) {
  const std::string plain(1'000'000, 'x');
  EXPECT_EQ(symbol_of(wall->run(alice->tell(list("note"_sym, 1, plain)))), "ok");
  EXPECT_EQ(ask(*bob, "(note 1 ?)").size(), 1U);
  const std::string escaped(600'000, '"');
  EXPECT_EQ(symbol_of(wall->run(alice->tell(list("note"_sym, 2, escaped)))), "too-large");
}

TEST_P(BoardFacts, AnswersThatFitNoMessageAreRefused) {
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(wall->run(alice->tell(list("note"_sym, i, std::string(300'000, 'x')))).has_value());
  }
  EXPECT_EQ(symbol_of(wall->run(bob->ask(query("(note ?n ?)")))), "too-large");
  EXPECT_EQ(symbol_of(wall->run(bob->watch(query("(and (note ?n ?) (note ?m ?))")))), "too-large");
  EXPECT_EQ(ask(*bob, "(query (note ?n ?) (order (down ?n)) (limit 1))").size(), 1U);
}

TEST_P(BoardFacts, ALeasedRelationsFactsGoUnlessToldAgain) {
  tell(*alice, "(alarm \"stale\")");
  tell(*alice, "(alarm \"fresh\")");
  for (int looks = 0; looks < 200 && holds(*bob, "(alarm \"stale\")"); ++looks) {
    tell(*alice, "(alarm \"fresh\")");
    wall->pass(50ms);
  }
  const std::vector<Answer> left = ask(*bob, "(alarm ?text)");
  EXPECT_EQ(values(left, "?text"), std::vector<Datum>{to_datum("fresh")});
}

INSTANTIATE_TEST_SUITE_P(Walls, BoardFacts, testing::ValuesIn(all_walls()), wall_name);

}  // namespace
}  // namespace pizarra
