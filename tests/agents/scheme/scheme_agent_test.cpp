// Scheme files as agents, on a board in virtual time.

#include "agents/scheme/scheme_agent.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/scratch.hpp"

namespace pizarra::scheme {
namespace {

constexpr const char* barrier = "(relation barrier ((name symbol) (state symbol)) (key name))";
constexpr const char* belt = "(posts (relation belt ((state symbol)) (key)))";

class SchemeFile : public testing::Test {
 protected:
  void SetUp() override { declare(barrier); }

  void declare(std::string_view relation) {
    ASSERT_TRUE(board.declare("user", {relation_from_datum(read_one(relation).value()).value()}));
  }
  // As an editor does: the file is another one.
  void save(const std::string& text) {
    std::ofstream(file_ + ".new") << text;
    std::filesystem::rename(file_ + ".new", file_);
    executor.run_for(1s);
  }
  void start(const std::string& text, SchemeOptions options = {}) {
    save(text);
    options.file = file_;
    options.log = [this](const std::string& line) { said += line + "\n"; };
    view = board.view("conveyor");
    agent.emplace(runtime::AgentContext{"conveyor", "localhost", executor, *view, Random(1)}, options);
    job = executor.spawn([](SchemeAgent& running, std::optional<Result<void>>& end) -> Task<void> {
      end = co_await running.run();
    }(*agent, ended));
    executor.run_for(2s);
  }
  void tell(std::string_view fact) {
    Transaction transaction;
    transaction.tell(read_one(fact).value());
    EXPECT_TRUE(board.transact("user", transaction)) << fact;
    executor.run_for(200ms);
  }
  void retract(std::string_view pattern) {
    Transaction transaction;
    transaction.retract(read_one(pattern).value());
    EXPECT_TRUE(board.transact("user", transaction));
    executor.run_for(200ms);
  }
  std::vector<Fact> facts(std::string_view pattern) {
    const Result<Answers> found = board.ask(query_for(read_one(pattern).value()));
    std::vector<Fact> out;
    if (!found) return out;
    for (const Answer& answer : found->answers) out.push_back(answer.facts.front());
    return out;
  }
  // The only fact that fits; empty where there is none.
  std::string fact(std::string_view pattern) {
    const std::vector<Fact> found = facts(pattern);
    return found.size() == 1 ? write(found.front().datum) : fmt::format("{} facts", found.size());
  }
  std::string call(std::string_view operation) {
    const Datum id = Datum::symbol(fmt::format("r{}", ++asked_));
    Transaction request;
    request.tell(list("request"_sym, id, "conveyor"_sym, read_one(operation).value()));
    EXPECT_TRUE(board.transact("user", request));
    executor.run_for(5s);
    const std::vector<Fact> replied = facts(fmt::format("(reply {} ?)", id.text()));
    return replied.empty() ? "" : write(replied.front().datum[2]);
  }

  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  std::unique_ptr<Board> view;
  std::optional<SchemeAgent> agent;
  std::optional<Result<void>> ended;
  std::string said;
  Job job;

 private:
  const std::string file_ = scratch_folder() + "conveyor.scm";
  int asked_ = 0;
};

TEST_F(SchemeFile, WhatItReadsMayBeDeclaredByItAndIsNotAmongWhatItPosts) {
  start(std::string(belt) + "(reads (relation door ((state symbol)) (key)) barrier)" +
        "(rule go (and (barrier exit free) (door open)) (tell (belt running)))");
  tell("(door open)");
  tell("(barrier exit free)");
  EXPECT_EQ(fact("(belt ?)"), "(belt running)") << said;
  const std::string contract = fact("(contract conveyor ?)");
  EXPECT_TRUE(contract.contains("(reads door barrier)")) << contract;
}

TEST_F(SchemeFile, RulesFireOnFactsAndTellFactsBecauseOfThem) {
  start(std::string(belt) + "(rule stop (barrier exit blocked) (tell (belt stopped)))");
  EXPECT_EQ(fact("(agent conveyor ? ?)"), "(agent conveyor conveyor \"localhost\")");
  EXPECT_EQ(fact("(belt ?)"), "0 facts");
  tell("(barrier exit blocked)");
  ASSERT_EQ(fact("(belt ?)"), "(belt stopped)") << said;
  const Fact told = facts("(belt ?)").front();
  EXPECT_EQ(told.teller, "conveyor");
  const std::vector<FactId> reasons{facts("(barrier ? ?)").front().id, facts("(rule ? ? ?)").front().id};
  EXPECT_EQ(told.because, reasons);
  EXPECT_EQ(fact("(rule ? ? ?)"), "(rule conveyor stop \"(barrier exit blocked)\")");
}

TEST_F(SchemeFile, AConclusionStandsWhileItsConditionDoes) {
  start("(posts (relation busy ((where symbol)))) (conclude busy (barrier ?b blocked) (busy ?b) (busy somewhere))");
  tell("(barrier exit blocked)");
  tell("(barrier door blocked)");
  EXPECT_EQ(facts("(busy ?)").size(), 3u);
  tell("(barrier exit free)");
  EXPECT_EQ(fact("(busy exit)"), "0 facts");
  EXPECT_EQ(fact("(busy somewhere)"), "(busy somewhere)");
  retract("(barrier ? ?)");
  EXPECT_EQ(facts("(busy ?)").size(), 0u);
}

TEST_F(SchemeFile, LoopsGoRoundAndOperationsAnswer) {
  start(
      "(define n 0) (posts (relation tick ((n integer)) (key)))"
      "(loop clock 100 (set! n (+ n 1)) (tell (tick ,n)))"
      "(operation (add (a number) (b number)) (+ a b))"
      "(operation (slowly) (pause 2000) n)"
      "(operation (never) (fail 'no \"not today\"))");
  EXPECT_EQ(call("(add 2 3)"), "(ok 5)");
  EXPECT_EQ(call("(add two 3)").substr(0, 5), "(fail");
  EXPECT_EQ(call("(never)"), "(fail no \"not today\" ())");
  EXPECT_EQ(call("(slowly)").substr(0, 4), "(ok ");
  EXPECT_GT(facts("(tick ?)").front().datum[1].integer(), 50);
}

TEST_F(SchemeFile, AsksTheBoardAndOtherAgents) {
  start(
      "(posts (relation report ((text list)) (key)))"
      "(rule report (barrier ?b ask) (tell (report ,(ask (barrier ?c ?s)))))"
      "(rule call (barrier ?b call) (tell (report ,(catch 'board-failure (lambda () (call nobody (go) 500))"
      "                                             (lambda (key symbol sentence) (list symbol))))))");
  tell("(barrier exit ask)");
  EXPECT_EQ(fact("(report ?)"), "(report ((exit ask)))") << said;
  tell("(barrier exit call)");
  executor.run_for(2s);
  EXPECT_EQ(fact("(report ?)"), "(report (timeout))") << said;
}

TEST_F(SchemeFile, IsLoadedAgainWhenItIsSavedAndWhatItDidNotTellAgainGoes) {
  start(std::string(belt) + "(rule stop (barrier ?b blocked) (tell (belt stopped)))");
  tell("(barrier exit blocked)");
  ASSERT_EQ(fact("(belt ?)"), "(belt stopped)");
  save(std::string(belt) + "(rule slow (barrier ?b blocked) (tell (belt slow)))");
  EXPECT_EQ(fact("(belt ?)"), "(belt slow)");
  EXPECT_EQ(fact("(program ? ? ?)"), "(program conveyor runs \"\")");
  save(belt);
  executor.run_for(4s);
  EXPECT_EQ(fact("(belt ?)"), "0 facts");
  EXPECT_EQ(facts("(rule ? ? ?)").size(), 0u);
}

TEST_F(SchemeFile, AFileThatDoesNotLoadKeepsTheOneBeforeAndSaysWhy) {
  start(std::string(belt) + "(rule stop (barrier ?b blocked) (tell (belt stopped)))");
  save(std::string(belt) + "\n(rule stop (barrier ?b blocked)\n  (tell (belt broken))");
  const std::vector<Fact> state = facts("(program conveyor kept ?)");
  ASSERT_EQ(state.size(), 1u) << said;
  EXPECT_TRUE(state.front().datum[3].text().starts_with("conveyor.scm:3:")) << state.front().datum[3].text();
  tell("(barrier exit blocked)");
  EXPECT_EQ(fact("(belt ?)"), "(belt stopped)");
  save(std::string(belt) + "(rule stop (barrier ?b blocked) (tell (belt mended)))");
  EXPECT_EQ(fact("(program ? ? ?)"), "(program conveyor runs \"\")");
  EXPECT_EQ(fact("(belt ?)"), "(belt mended)");
}

TEST_F(SchemeFile, AConditionThatIsNoQueryIsRefusedWithItsRulesName) {
  start("(rule odd (and (barrier ?b ?s) (< ?s ?t)) (tell (x)))");
  const std::vector<Fact> state = facts("(program conveyor broken ?)");
  ASSERT_EQ(state.size(), 1u) << said;
  EXPECT_NE(state.front().datum[3].text().find("the condition of odd"), std::string::npos);
}

TEST_F(SchemeFile, OffersOtherOperationsOnceItIsLoaded) {
  start("(operation (first) 1)");
  EXPECT_EQ(call("(first)"), "(ok 1)");
  save("(operation (second) 2)");
  executor.run_for(3s);
  EXPECT_EQ(call("(second)"), "(ok 2)");
  EXPECT_EQ(call("(first)").substr(0, 5), "(fail");
}

TEST_F(SchemeFile, ARuleThatBreaksALimitIsOffAndTheOthersGoOn) {
  start(std::string(belt) +
            "(rule forever (barrier ?b blocked) (let again () (again)))"
            "(rule stop (barrier ?b blocked) (tell (belt stopped)))",
        {.file = "", .limits = {.time = std::chrono::milliseconds(100), .memory_mb = 1000}, .log = nullptr});
  tell("(barrier exit blocked)");
  EXPECT_EQ(fact("(belt ?)"), "(belt stopped)");
  ASSERT_EQ(facts("(program-fault conveyor forever ?)").size(), 1u) << said;
  const std::string why(facts("(program-fault conveyor forever ?)").front().datum[3].text());
  EXPECT_NE(why.find("longer than 0.1 s"), std::string::npos) << why;
  EXPECT_NE(why.find("is off until"), std::string::npos) << why;
  const auto before = std::chrono::steady_clock::now();
  for (int i = 0; i < 20; ++i) tell(fmt::format("(barrier b{} blocked)", i));
  EXPECT_LT(std::chrono::steady_clock::now() - before, std::chrono::seconds(1));
}

TEST_F(SchemeFile, AFloodOfFactsIsSlowedDown) {
  start(
      "(posts (relation flood ((n integer)) (key)))"
      "(rule flood (flood ?n) (tell (flood ,(+ ?n 1)))) (tell (flood 0))",
      {.file = "", .limits = {}, .messages_per_s = 100, .log = nullptr});
  executor.run_for(10s);
  const std::int64_t told = facts("(flood ?)").front().datum[1].integer();
  EXPECT_GT(told, 1000);
  EXPECT_LT(told, 1500);
}

TEST_F(SchemeFile, WhatIsWrongWithAFactIsToldAndNothingOfTheRunStands) {
  start(std::string(belt) + "(rule stop (barrier ?b blocked) (tell (belt stopped) (nowhere 1)))");
  tell("(barrier exit blocked)");
  EXPECT_EQ(fact("(belt ?)"), "0 facts");
  const std::vector<Fact> faults = facts("(program-fault conveyor stop ?)");
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_NE(faults.front().datum[3].text().find("nowhere"), std::string::npos);
}

TEST_F(SchemeFile, WhatItToldGoesWithItUnlessItIsDurable) {
  start(
      "(posts (relation belt ((state symbol)) (key)) (relation count ((n integer)) (key) (durable)))"
      "(rule stop (barrier exit blocked) (tell (belt stopped) (count 1)))");
  tell("(barrier exit blocked)");
  job = Job();
  executor.run_for(5s);
  EXPECT_EQ(fact("(belt ?)"), "0 facts");
  EXPECT_EQ(fact("(count ?)"), "(count 1)");
}

TEST_F(SchemeFile, EndsWhenItKeepsMoreThanItMay) {
  start("(define all '()) (loop keep 10 (set! all (cons (make-vector 100000 0) all)))",
        {.file = "", .limits = {.memory_mb = 16}, .log = nullptr});
  executor.run_for(5s);
  ASSERT_TRUE(ended.has_value());
  EXPECT_EQ(ended->error().symbol, "too-much-kept");
}

TEST_F(SchemeFile, FollowsRelationsThatAreDeclaredLater) {
  start(std::string(belt) + "(rule later (later ?x) (tell (belt ?x)))");
  declare("(relation later ((x symbol)))");
  tell("(later here)");
  executor.run_for(1s);
  EXPECT_EQ(fact("(belt ?)"), "(belt here)");
}

TEST_F(SchemeFile, AConclusionIsToldOnceItsRelationIsDeclared) {
  start("(conclude busy (barrier ?b blocked) (occupied ?b))");
  tell("(barrier exit blocked)");
  tell("(barrier door blocked)");
  executor.run_for(10s);
  EXPECT_NE(fact("(program-fault conveyor busy ?)").find("occupied"), std::string::npos);
  // It is tried again and again, and said once for each.
  EXPECT_LE(std::ranges::count(said, '\n'), 3) << said;
  // What has ceased meanwhile is not told.
  tell("(barrier door free)");
  declare("(relation occupied ((where symbol)))");
  executor.run_for(2s);
  EXPECT_EQ(fact("(occupied ?)"), "(occupied exit)");
  EXPECT_EQ(fact("(program-fault ? ? ?)"), "0 facts");
  tell("(barrier door blocked)");
  EXPECT_EQ(facts("(occupied ?)").size(), 2u);
  retract("(barrier ? ?)");
  EXPECT_EQ(fact("(occupied ?)"), "0 facts");
}

}  // namespace
}  // namespace pizarra::scheme
