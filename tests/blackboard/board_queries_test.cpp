#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

class BoardQueries : public BoardTest {
 protected:
  void tell_all(std::initializer_list<const char*> facts) {
    for (const char* fact : facts) ASSERT_EQ(symbol_of(tell(*alice, fact)), "ok");
  }
};

TEST_P(BoardQueries, PatternsShareVariables) {
  tell_all({"(on a b)", "(on b c)", "(on d e)", "(on f f)"});
  const std::vector<Answer> towers = ask(*bob, "(and (on ?x ?y) (on ?y ?z))");
  EXPECT_EQ(values(towers, "?x"), (std::vector<Datum>{"a"_sym, "f"_sym}));
  EXPECT_EQ(values(towers, "?z"), (std::vector<Datum>{"c"_sym, "f"_sym}));
  EXPECT_EQ(towers.front().facts.size(), 2U);
  EXPECT_EQ(ask(*bob, "(on ?x ?x)").size(), 1U);
}

TEST_P(BoardQueries, NotRefusesWhatIsThere) {
  tell_all({"(on a b)", "(on b c)", "(mode idle)"});
  EXPECT_EQ(values(ask(*bob, "(and (on ?x ?y) (not (on ?z ?x)))"), "?x"), std::vector<Datum>{"a"_sym});
  EXPECT_EQ(ask(*bob, "(not (mode ready))").size(), 1U);
  EXPECT_TRUE(ask(*bob, "(not (mode ?m))").empty());
}

TEST_P(BoardQueries, ComparisonsAreNumericAcrossKinds) {
  tell_all({"(seen \"a\" 1 5)", "(seen \"b\" 2.5 5)", "(seen \"c\" 3.0 3)"});
  EXPECT_EQ(ask(*bob, "(and (seen ?n ?x ?y) (< ?x 3))").size(), 2U);
  EXPECT_EQ(ask(*bob, "(and (seen ?n ?x ?y) (<= ?x 3))").size(), 3U);
  EXPECT_EQ(ask(*bob, "(and (seen ?n ?x ?y) (> ?x 1.0))").size(), 2U);
  EXPECT_EQ(ask(*bob, "(and (seen ?n ?x ?y) (>= ?x ?y))").size(), 1U);
  EXPECT_EQ(ask(*bob, "(and (seen ?n ?x ?y) (= ?x ?y))").size(), 1U);
  EXPECT_EQ(ask(*bob, "(and (seen ?n ?x ?y) (/= ?n \"a\"))").size(), 2U);
  EXPECT_TRUE(ask(*bob, "(and (seen ?n ?x ?y) (< ?n 3))").empty());
}

TEST_P(BoardQueries, AnswersComeInTheFactsOrderOrAsAsked) {
  tell_all({"(seen \"a\" 2 0)", "(seen \"b\" 10 0)", "(seen \"c\" 2.5 0)", "(seen \"d\" 2 1)"});
  const auto names = [&](const std::string& text) {
    std::string found;
    for (const Datum& name : values(ask(*bob, text), "?n")) found += name.text();
    return found;
  };
  EXPECT_EQ(names("(seen ?n ?x ?y)"), "abcd");
  EXPECT_EQ(names("(query (seen ?n ?x ?y) (order ?x))"), "adcb");
  EXPECT_EQ(names("(query (seen ?n ?x ?y) (order (down ?x)))"), "bcad");
  EXPECT_EQ(names("(query (seen ?n ?x ?y) (order ?x) (limit 2))"), "ad");
  EXPECT_EQ(names("(query (seen ?n ?x ?y) (limit 3))"), "abc");
  EXPECT_EQ(names("(query (seen ?n ?x ?y) (limit 0))"), "");
}

TEST_P(BoardQueries, BadQueriesAreRefused) {
  for (const char* text :
       {"(and)", "word", "(?r a b)", "(and (on ?x ?y) (< ?z 3))", "(query (on ?x ?y) (order ?z))",
        "(query (on ?x ?y) (order ?x) (order ?y))", "(query (on ?x ?y) (limit 1) (limit 2))", "(not)",
        "(and (on a b) (not (not (on a b))))", "(query (on ?x ?y) (limit -1))", "(and (seen ?n ?x ?y) (< ?x \"a\"))",
        "(and (on ?x ?y) (=  ?x))", "(query (on ?x ?y) (sort ?x))", "(not (and (on a b) (on b c)))", "((on a b))"}) {
    EXPECT_EQ(symbol_of(query_from_datum(read(text))), "bad-query") << text;
  }
  Query unbound;
  unbound.clauses.push_back({Query::Clause::Kind::compare, read("(< ?x 3)")});
  EXPECT_EQ(symbol_of(wall->run(alice->ask(unbound))), "bad-query");
  EXPECT_EQ(symbol_of(wall->run(alice->watch(unbound))), "bad-query");
  EXPECT_EQ(symbol_of(wall->run(alice->ask(Query()))), "bad-query");
}

TEST_P(BoardQueries, AnAnswerNamesTheRevisionItHeldAt) {
  const Result<Revision> revision = tell(*alice, "(on a b)");
  EXPECT_EQ(wall->run(bob->ask(query("(on ?x ?y)")))->revision, *revision);
}

TEST_P(BoardQueries, TheBoardSaysOfEveryRelationWhoTellsAndWhoWatches) {
  const std::unique_ptr<Watch> watched = wall->run(bob->watch(query("(and (on ?x ?y) (not (on ?y a)))"))).value();
  tell_all({"(on a b)", "(on b c)", "(mode idle)", "(mode ready)"});
  ASSERT_EQ(symbol_of(tell(*bob, "(on c d)")), "ok");
  const std::vector<Answer> answers = ask(*bob, "(relation-stats on ?facts ?told ?gone ? ?tellers ?watchers)");
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers[0].facts[0].datum[2], to_datum(3));
  EXPECT_EQ(answers[0].facts[0].datum[3], to_datum(3));
  EXPECT_EQ(*answers[0].bindings.find("?tellers"), read("((\"alice\" 2) (\"bob\" 1))"));
  EXPECT_EQ(*answers[0].bindings.find("?watchers"), read("((\"bob\" 2))"));
  const std::vector<Answer> mode = ask(*alice, "(relation-stats mode ?facts ?told ?gone ? ? ?)");
  EXPECT_EQ(values(mode, "?told"), std::vector<Datum>{to_datum(2)});
  EXPECT_EQ(values(mode, "?gone"), std::vector<Datum>{to_datum(1)});
  EXPECT_EQ(values(ask(*alice, "(and (relation-stats ?name ? ?told ? ? ? ?) (> ?told 2))"), "?name"),
            std::vector<Datum>{"on"_sym});
  EXPECT_EQ(symbol_of(wall->run(bob->ask(query("(and (on ?x ?y) (relation-stats on ? ? ? ? ? ?))")))), "bad-query");
  EXPECT_EQ(symbol_of(tell(*bob, "(relation-stats on 1 1 1 1 () ())")), "not-permitted");
}

TEST_P(BoardQueries, AwaitAnswersWhatHoldsOrComesToHold) {
  const Time soon = wall->executor().now() + 100ms;
  EXPECT_EQ(symbol_of(wall->run(await_answer(*bob, query("(on a ?y)"), soon, wall->executor()))), "timeout");
  Job later;
  wall->executor().call_at(wall->executor().now() + 50ms, [&] {
    later = wall->executor().spawn([](Board& board) -> Task<void> {
      Datum fact = read_one("(on a b)").value();
      co_await board.tell(fact);
    }(*alice));
  });
  const Time later_on = wall->executor().now() + 5s;
  const Result<Answer> answer = wall->run(await_answer(*bob, query("(on a ?y)"), later_on, wall->executor()));
  ASSERT_TRUE(answer.has_value());
  EXPECT_EQ(*answer->bindings.find("?y"), "b"_sym);
  EXPECT_EQ(symbol_of(wall->run(await_answer(*bob, query("(on a ?y)"), soon, wall->executor()))), "ok");
}

INSTANTIATE_TEST_SUITE_P(Walls, BoardQueries, testing::ValuesIn(all_walls()), wall_name);

}  // namespace
}  // namespace pizarra
