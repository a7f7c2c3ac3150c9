#include <gtest/gtest.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/server/board_server.hpp"
#include "blackboard/time/random.hpp"
#include "blackboard/time/real_executor.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/board_fixture.hpp"

namespace pizarra {
namespace {

const Relation numbers = relation("(relation number ((name symbol) (value integer) (owner symbol)) (key name))");
const Relation others = relation("(relation other ((name symbol)))");

class ReplicaTest : public testing::Test, public Wall {
 protected:
  ReplicaTest() { start_server(); }
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override { return remote(teller); }
  std::unique_ptr<client::RemoteBoard> remote(const std::string& teller) {
    auto board = client::RemoteBoard::connect(executor_, address_, teller).value();
    const std::vector<Relation> relations = {numbers, others};
    EXPECT_EQ(symbol_of(run(board->declare(relations))), "ok");
    return board;
  }
  std::unique_ptr<client::RemoteBoard> holder(const std::string& teller) {
    auto board = remote(teller);
    EXPECT_EQ(symbol_of(run(board->replicate(numbers))), "ok");
    return board;
  }
  void start_server() {
    board_ = std::make_unique<memory::MemoryBoard>(executor_);
    server_ = server::BoardServer::open(executor_, *board_, {.addresses = {address_}}).value();
  }
  void stop_server() {
    server_.reset();
    board_.reset();
  }
  static Datum number(int name, int value, const std::string& owner = "me") {
    return list("number"_sym, Datum::symbol("n" + std::to_string(name)), value, Datum::symbol(owner));
  }
  // What is answered without the server: the task ends before anything is said to it.
  std::optional<Answers> held(Board& board, const std::string& text) {
    std::optional<Answers> answers;
    const auto ask = [](Board& b, Query query, std::optional<Answers>& out) -> Task<void> {
      Result<Answers> result = co_await b.ask(query);
      if (result) out = std::move(*result);
    };
    Job asking = executor_.spawn(ask(board, query(text), answers));
    int steps = 0;
    executor_.run_until([&] { return asking.done() || ++steps > 3; });
    return answers;
  }

  const std::string address_ = ipc_address();
  RealExecutor executor_;
  std::unique_ptr<memory::MemoryBoard> board_;
  std::unique_ptr<server::BoardServer> server_;
};

TEST_F(ReplicaTest, AQuestionAboutAHeldRelationIsAnsweredWithoutTheServer) {
  const auto writer = remote("writer");
  const Revision revision = run(writer->tell(number(1, 5))).value();
  const auto board = holder("holder");
  const std::optional<Answers> answers = held(*board, "(number n1 ?v ?)");
  ASSERT_TRUE(answers.has_value());
  EXPECT_EQ(values(answers->answers, "?v"), std::vector<Datum>{to_datum(5)});
  EXPECT_EQ(answers->answers.front().facts.front().teller, "writer");
  EXPECT_GE(answers->revision, revision);
}

TEST_F(ReplicaTest, WhatIsNotHeldIsAskedOfTheServer) {
  const auto board = holder("holder");
  ASSERT_EQ(symbol_of(run(board->tell(number(1, 5)))), "ok");
  ASSERT_EQ(symbol_of(run(board->tell(read("(other n1)")))), "ok");
  EXPECT_FALSE(held(*board, "(other ?n)").has_value());
  EXPECT_FALSE(held(*board, "(and (number ?n ?v ?) (not (other ?n)))").has_value()) << "two relations, two revisions";
  EXPECT_EQ(run(board->ask(query("(other ?n)")))->answers.size(), 1U);
  EXPECT_TRUE(run(board->ask(query("(and (number ?n ?v ?) (not (other ?n)))")))->answers.empty());
}

TEST_F(ReplicaTest, AMalformedQuestionFailsAsItDoesAtTheServer) {
  const auto plain = remote("plain");
  const auto board = holder("holder");
  for (const char* text : {"(number 5 ?v ?)", "(number ?n ?v)", "(and (number ?n ?v ?o) (number ?n ?v))"}) {
    EXPECT_EQ(symbol_of(run(board->ask(query(text)))), symbol_of(run(plain->ask(query(text))))) << text;
    EXPECT_NE(symbol_of(run(board->ask(query(text)))), "ok") << text;
  }
}

TEST_F(ReplicaTest, ARelationLargerThanAMessageIsHeldWhole) {
  const auto writer = remote("writer");
  constexpr int many = 20'000;
  for (int n = 0; n < many; n += 1000) {
    Transaction facts;
    for (int i = n; i < n + 1000; ++i) facts.tell(number(i, i));
    ASSERT_EQ(symbol_of(run(writer->transact(facts))), "ok");
  }
  const auto board = holder("holder");
  for (const int n : {0, 1, many / 2, many - 1}) {
    const auto answers = held(*board, "(number n" + std::to_string(n) + " ?v ?)");
    ASSERT_TRUE(answers.has_value());
    EXPECT_EQ(values(answers->answers, "?v"), std::vector<Datum>{to_datum(n)});
  }
  EXPECT_EQ(held(*board, "(query (number ?n ?v ?) (order (down ?v)) (limit 1))")->answers.size(), 1U);
}

// Every one tells and takes away its own and others' facts, and asks at once whether its own write shows.
TEST_F(ReplicaTest, EveryWriterReadsItsOwnWritesAmongManyOthers) {
  constexpr int writers = 8;
  constexpr int rounds = 150;
  int wrong = 0;
  int done = 0;
  const auto write_and_read = [](Board& board, int own, int& bad, int& ended) -> Task<void> {
    Random random(static_cast<std::uint64_t>(own));
    for (int round = 1; round <= rounds; ++round) {
      const int disturbed = static_cast<int>(random.below(writers));
      Datum shared = number(100 + disturbed, round);
      const Result<Revision> disturbing = co_await board.tell(shared);
      Datum fact = number(own, round);
      const Result<Revision> told = co_await board.tell(fact);
      Query mine = query("(number n" + std::to_string(own) + " ?v ?)");
      const Result<Answers> seen = co_await board.ask(mine);
      const bool good = disturbing.has_value() && told.has_value() && seen.has_value();
      if (!good || seen->answers.size() != 1 || seen->revision < *told) ++bad;
      if (good && seen->answers[0].facts[0].datum != fact) ++bad;
      if (round % 10 != 0) continue;
      Datum pattern = fact;
      const Result<std::optional<Fact>> taken = co_await board.take(pattern, 0);
      const Result<Answers> gone = co_await board.ask(mine);
      if (!taken || !*taken || !gone || !gone->answers.empty()) ++bad;
    }
    ++ended;
  };
  std::vector<std::unique_ptr<client::RemoteBoard>> boards;
  std::vector<Job> jobs;
  for (int i = 0; i < writers; ++i) boards.push_back(holder("w" + std::to_string(i)));
  for (int i = 0; i < writers; ++i) jobs.push_back(executor_.spawn(write_and_read(*boards[i], i, wrong, done)));
  executor_.run_until([&] { return done == writers; });
  EXPECT_EQ(wrong, 0);
}

TEST_F(ReplicaTest, ItAnswersWhatTheServerAnswers) {
  constexpr std::uint64_t seed = 5;
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  const auto writer = remote("writer");
  const auto board = holder("holder");
  const std::vector<std::string> questions = {"(number ?n ?v ?o)",
                                              "(number n3 ?v ?o)",
                                              "(and (number ?n ?v a) (> ?v 3))",
                                              "(and (number ?n ?v ?o) (not (number ? ?v b)))",
                                              "(and (number ?n ?v a) (number ?m ?v b))",
                                              "(query (number ?n ?v ?o) (order (down ?v)) (limit 3))"};
  const auto written = [](const Answers& answers) {
    std::string text;
    for (const Answer& answer : answers.answers) {
      for (const Fact& fact : answer.facts) text += std::to_string(fact.id) + write(fact.datum);
    }
    return text;
  };
  for (int round = 0; round < 60; ++round) {
    Transaction changes;
    for (int i = 0; i < 5; ++i) {
      const int name = static_cast<int>(random.below(8));
      const int value = static_cast<int>(random.below(6));
      changes.tell(number(name, value, random.below(2) == 0 ? "a" : "b"));
      if (random.below(4) == 0) changes.retract(number(static_cast<int>(random.below(8)), value, "a"));
    }
    ASSERT_EQ(symbol_of(run(writer->transact(changes))), "ok");
    // Its own write brings the holder up to date.
    ASSERT_EQ(symbol_of(run(board->tell(number(100, round)))), "ok");
    const std::string& question = questions[random.below(questions.size())];
    const std::optional<Answers> here = held(*board, question);
    ASSERT_TRUE(here.has_value()) << question;
    ASSERT_EQ(written(*here), written(run(writer->ask(query(question))).value())) << question;
  }
}

TEST_F(ReplicaTest, AfterTheServerWasLostItHoldsWhatTheNextOneHas) {
  const auto board = holder("holder");
  ASSERT_EQ(symbol_of(run(board->tell(number(1, 5)))), "ok");
  ASSERT_EQ(held(*board, "(number ?n ?v ?)")->answers.size(), 1U);
  stop_server();
  pass(50ms);
  start_server();
  const auto writer = remote("writer");
  ASSERT_EQ(symbol_of(run(writer->tell(number(2, 7)))), "ok");
  std::optional<Answers> answers;
  executor_.run_until([&] {
    answers = std::nullopt;
    return board->connected();
  });
  for (int tries = 0;
       tries < 100 && (!answers || answers->answers.size() != 1 || values(answers->answers, "?n")[0] != "n2"_sym);
       ++tries) {
    pass(20ms);
    answers = held(*board, "(number ?n ?v ?)");
  }
  ASSERT_TRUE(answers.has_value());
  EXPECT_EQ(values(answers->answers, "?n"), std::vector<Datum>{"n2"_sym});
}

}  // namespace
}  // namespace pizarra
