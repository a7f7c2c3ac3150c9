#include "agents/repl/interpreter.hpp"

#include <gtest/gtest.h>

#include "agents/repl/commands.hpp"
#include "agents/repl/terminal.hpp"
#include "blackboard/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"

namespace pizarra {
namespace {

class Repl : public testing::Test {
 protected:
  void SetUp() override {
    presence = executor.spawn(start());
    executor.run_for(1s);
    board
        .declare("test",
                 {relation_from_datum(read_one("(relation on ((upper symbol) (lower symbol)))").value()).value()})
        .value();
  }
  Task<void> start() {
    const Result<void> started = co_await service.start();
    EXPECT_TRUE(started.has_value());
  }
  Task<void> evaluate_into(std::string text, Evaluation& outcome) { outcome = co_await interpreter.evaluate(text); }
  Evaluation type(std::string text) {
    shown.clear();
    Evaluation outcome = Evaluation::quit;
    const Job job = executor.spawn(evaluate_into(std::move(text), outcome));
    executor.run_until([&] { return job.done(); });
    return outcome;
  }

  VirtualExecutor executor;
  MemoryBoard board{executor};
  std::unique_ptr<Board> view = board.view("user");
  AgentContext context{"user", "localhost", executor, *view, Random(1)};
  Service service{context, contract_from_text("(contract user)").value()};
  std::string shown;
  Interpreter interpreter{context, service, [this](const std::string& line) { shown += line + '\n'; },
                          Interpreter::Patience::ended};
  Job presence;
};

TEST_F(Repl, TellsAsksAndRetracts) {
  EXPECT_EQ(type("(ask (on ?x ?y))"), Evaluation::done);
  EXPECT_EQ(shown, "no\n");
  EXPECT_EQ(type("(tell (on circle triangle)) (tell (on triangle square))"), Evaluation::done);
  EXPECT_EQ(type("(ask (on ?x ?y))"), Evaluation::done);
  EXPECT_EQ(shown, "?x = circle  ?y = triangle\n?x = triangle  ?y = square\n");
  EXPECT_EQ(type("(ask (on circle triangle))"), Evaluation::done);
  EXPECT_EQ(shown, "yes\n");
  EXPECT_EQ(type("(retract (on circle ?))"), Evaluation::done);
  EXPECT_TRUE(shown.starts_with("retracted 1"));
}

TEST_F(Repl, WatchesUntilUnwatched) {
  EXPECT_EQ(type("(watch (on ?x ?y))"), Evaluation::done);
  executor.run_for(1s);
  EXPECT_NE(shown.find("nothing yet"), std::string::npos);
  type("(tell (on circle triangle))");
  executor.run_for(1s);
  EXPECT_NE(shown.find("[1] + ?x = circle  ?y = triangle"), std::string::npos) << shown;
  type("(retract (on ? ?))");
  executor.run_for(1s);
  EXPECT_NE(shown.find("[1] - ?x = circle"), std::string::npos) << shown;
  EXPECT_EQ(type("(unwatch 1)"), Evaluation::done);
  type("(tell (on cross square))");
  executor.run_for(1s);
  EXPECT_EQ(shown.find("[1]"), std::string::npos) << shown;
  EXPECT_EQ(type("(unwatch 1)"), Evaluation::failed);
}

TEST_F(Repl, SaysWhatIsWrongWithAPlace) {
  EXPECT_EQ(type("(aks (on ?x ?y))"), Evaluation::malformed);
  EXPECT_NE(shown.find("did you mean ask?"), std::string::npos) << shown;
  EXPECT_NE(shown.find("1:1"), std::string::npos) << shown;
  EXPECT_EQ(type("(ask (on ?x"), Evaluation::malformed);
  EXPECT_NE(shown.find('^'), std::string::npos) << shown;
  EXPECT_EQ(type("(tell (onn circle triangle))"), Evaluation::failed);
  EXPECT_NE(shown.find("on"), std::string::npos) << shown;
  EXPECT_EQ(type("42"), Evaluation::malformed);
  EXPECT_EQ(type("(ask)"), Evaluation::malformed);
  EXPECT_EQ(type("(unwatch all)"), Evaluation::malformed);
}

TEST_F(Repl, ACommandNeedsNoParenthesesOfItsOwn) {
  EXPECT_EQ(type("help"), Evaluation::done);
  for (const Command& command : Command::all()) {
    EXPECT_NE(shown.find(command.usage), std::string::npos) << command.name;
  }
  EXPECT_EQ(type("quit"), Evaluation::quit);
}

TEST_F(Repl, StopsAtTheFirstFormThatFails) {
  EXPECT_EQ(type("(tell (on a)) (tell (on a b))"), Evaluation::failed);
  EXPECT_EQ(type("(ask (on ?x ?y))"), Evaluation::done);
  EXPECT_EQ(shown, "no\n");
}

TEST(Terminal, KnowsWhenAFormIsComplete) {
  for (const std::string_view whole : {"", "(a)", "a", "(a \")\")", "(a) ; (", "(a))", "(a \"\\\"\")"}) {
    EXPECT_TRUE(is_complete(whole)) << whole;
  }
  for (const std::string_view partial : {"(", "(a (b)", "\"a", "(a \"b)", "(a ; )\n"}) {
    EXPECT_FALSE(is_complete(partial)) << partial;
  }
}

}  // namespace
}  // namespace pizarra
