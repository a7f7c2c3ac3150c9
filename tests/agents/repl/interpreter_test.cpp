#include "agents/repl/interpreter.hpp"

#include <gtest/gtest.h>

#include "agents/repl/terminal.hpp"
#include "blackboard/memory/memory_board.hpp"
#include "blackboard/time/virtual_executor.hpp"
#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "tests/blackboard/passing_board.hpp"

namespace pizarra::repl {
namespace {

// Counts the questions that the board refuses.
class CountingBoard : public PassingBoard {
 public:
  CountingBoard(std::unique_ptr<Board> board, int& refused) : PassingBoard(std::move(board)), refused_(refused) {}
  Task<Result<Answers>> ask(Query query) override {
    Result<Answers> answers = co_await PassingBoard::ask(std::move(query));
    refused_ += answers ? 0 : 1;
    co_return answers;
  }

 private:
  int& refused_;
};

class Repl : public testing::Test {
 protected:
  explicit Repl(Style style = Style::text) : style_(style) {}
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

  Style style_;
  VirtualExecutor executor;
  memory::MemoryBoard board{executor};
  int refused = 0;
  std::unique_ptr<Board> view = std::make_unique<CountingBoard>(board.view("user"), refused);
  runtime::AgentContext context{"user", "localhost", executor, *view, Random(1)};
  runtime::Service service{context, runtime::contract_from_text("(contract user)").value()};
  std::string shown;
  Interpreter interpreter{context, service, [this](const std::string& line) { shown += line + '\n'; }, Patience::ended,
                          style_};
  Job presence;
};

TEST_F(Repl, SaysBecauseOfWhatAFactStandsAndWhatHasGone) {
  const auto tell = [&](const char* fact, std::vector<FactId> because) {
    Transaction telling;
    telling.tell(read_one(fact).value(), std::move(because));
    EXPECT_TRUE(board.transact("eyes", telling).has_value());
    return board.ask(query_for(read_one(fact).value()))->answers.front().facts.front().id;
  };
  const FactId seen = tell("(on a b)", {});
  const FactId gone = tell("(on b c)", {});
  const FactId middle = tell("(on c d)", {seen, gone});
  tell("(on d e)", {middle});
  ASSERT_TRUE(board.transact("eyes", Transaction().retract(read_one("(on b c)").value())).has_value());
  EXPECT_EQ(type("(why (on d ?y))"), Evaluation::done);
  EXPECT_EQ(shown,
            "(on d e)  by eyes\n  because (on c d)  by eyes\n    because (on a b)  by eyes\n    because of fact " +
                std::to_string(gone) + ", which is not there any more\n");
}

TEST_F(Repl, ShowsAPlanWithWhatIsDoneAndWhatIsInHand) {
  const auto relation = [](const char* text) { return relation_from_datum(read_one(text).value()).value(); };
  board
      .declare("test", {relation("(relation plan ((goal integer) (operations list)) (key))"),
                        relation("(relation operation ((index integer) (operation list) (state symbol)) (key))")})
      .value();
  EXPECT_EQ(type("(tell (plan 1 ((PICK-UP a) (STACK a b) (PICK-UP c)))) (tell (operation 1 (STACK a b) running))"),
            Evaluation::done);
  EXPECT_EQ(type("(plan)"), Evaluation::done);
  EXPECT_EQ(shown,
            "plan for goal 1:\n"
            "   1  (PICK-UP a)                    done\n"
            "   2  (STACK a b)                    running\n"
            "   3  (PICK-UP c)\n");
}

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

TEST_F(Repl, WhatIsDeclaredCanBeTold) {
  EXPECT_EQ(type("(tell (seen circle 112))"), Evaluation::failed);
  EXPECT_EQ(type("(declare (relation seen ((name symbol) (x number)) (key name)))"), Evaluation::done);
  EXPECT_EQ(shown, "declared seen\n");
  EXPECT_EQ(type("(tell (seen circle 111)) (tell (seen circle 112))"), Evaluation::done);
  EXPECT_EQ(type("(ask (seen ?name ?x))"), Evaluation::done);
  EXPECT_EQ(shown, "?name = circle  ?x = 112\n");
  EXPECT_EQ(type("(declare (relation seen ((name string)) (key name)))"), Evaluation::failed);
  EXPECT_EQ(type("(declare (seen name x))"), Evaluation::malformed);
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

// The watch is not read while more is told than it holds.
TEST_F(Repl, AWatchThatMissedChangesSaysThatWhatItShowedIsVoid) {
  type("(tell (on circle triangle))");
  type("(watch (on ?x ?y))");
  executor.run_for(1s);
  EXPECT_EQ(shown, "watch 1\n[1] + ?x = circle  ?y = triangle\n");
  const auto told = [&](const Transaction& transaction) {
    EXPECT_TRUE(board.transact("test", transaction).has_value());
  };
  const auto miss_changes = [&] {
    shown.clear();
    for (int n = 0; n < 2000; ++n) {
      told(Transaction().tell(list("on"_sym, Datum::symbol("cube-" + std::to_string(n)), "table"_sym)));
    }
    told(Transaction().retract(read_one("(on ? ?)").value()));
  };
  miss_changes();
  told(Transaction().tell(read_one("(on cross square)").value()));
  executor.run_for(1s);
  const std::string gap = "[1] changes were missed: what was shown before is void, and this stands now\n";
  EXPECT_EQ(shown, gap + "[1] + ?x = cross  ?y = square\n");
  miss_changes();
  executor.run_for(1s);
  EXPECT_EQ(shown, gap + "[1] nothing\n");
}

TEST_F(Repl, SaysWhatIsWrongWithAPlace) {
  EXPECT_EQ(type("(aks (on ?x ?y))"), Evaluation::malformed);
  EXPECT_NE(shown.find("did you mean ask?"), std::string::npos) << shown;
  EXPECT_NE(shown.find("1:1"), std::string::npos) << shown;
  EXPECT_EQ(type("(ask (on ?x"), Evaluation::malformed);
  EXPECT_NE(shown.find('^'), std::string::npos) << shown;
  EXPECT_EQ(type("(tell (onn circle triangle))"), Evaluation::failed);
  EXPECT_NE(shown.find("on"), std::string::npos) << shown;
  EXPECT_EQ(type("(" + std::string(5000, 'x') + ")"), Evaluation::malformed);
  EXPECT_LT(shown.size(), 300U) << shown;
  EXPECT_EQ(type("42"), Evaluation::malformed);
  EXPECT_EQ(type("(ask)"), Evaluation::malformed);
  EXPECT_EQ(type("(unwatch all)"), Evaluation::malformed);
}

TEST_F(Repl, ARelationIsNamedByItsBeginning) {
  board.declare("test", {relation_from_datum(read_one("(relation on-table ((upper symbol)))").value()).value()})
      .value();
  EXPECT_EQ(type("(ask (on-t ?x))"), Evaluation::failed);
  EXPECT_EQ(shown, "no relation is called on-t; did you mean on-table?\n");
}

TEST_F(Repl, AGoalIsRefusedWhileObjectsAreBeingTaught) {
  const Datum person = read_one("(relation person ((state symbol) (detail string)) (key))").value();
  board.declare("test", {relation_from_datum(person).value()}).value();
  type("(tell (agent coordinator coordinator \"here\")) (tell (agent person person \"here\"))");
  EXPECT_EQ(type("(goal (on circle triangle))"), Evaluation::refused);
  EXPECT_NE(shown.find("still being taught"), std::string::npos) << shown;
  type("(tell (person teaching \"circle\"))");
  EXPECT_EQ(type("(goal (on circle triangle))"), Evaluation::refused);
}

// Eyes that answer every request with `ok`, and tell what they are told to.
class ReplOfEyes : public Repl {
 protected:
  void SetUp() override {
    Repl::SetUp();
    answering = executor.spawn(answer());
    executor.run_for(1s);
  }
  Task<void> answer() {
    const Result<void> started = co_await eyes_service.start();
    EXPECT_TRUE(started.has_value());
    runtime::RequestHandler handler = [this](Fact) { return say_answer(); };
    const Result<void> served = co_await eyes_service.serve_requests(std::move(handler));
  }
  Task<Result<Datum>> say_answer() { co_return answered; }
  static Task<Result<Datum>> say_true() { co_return list("true"_sym); }
  void eyes_tell(std::string_view fact) {
    ASSERT_TRUE(board.transact("vision", Transaction().tell(read_one(fact).value())).has_value());
  }
  Task<void> lose_the_camera_later() {
    co_await sleep(executor, 1s);
    eyes_tell("(camera-state vision lost \"the camera: /dev/video0 cannot be opened\")");
  }
  void learn(std::string_view name) { eyes_tell("(learned vision \"" + std::string(name) + "\" 1 900 110 0 1 1 1)"); }

  Datum answered;  // by the eyes, to whatever they are asked
  std::unique_ptr<Board> eyes_view = board.view("vision");
  runtime::AgentContext eyes_context{"vision", "localhost", executor, *eyes_view, Random(1)};
  runtime::Service eyes_service{eyes_context, runtime::contract_from_text(R"((contract vision
    (offers (connect) (find (name string)))
    (posts
      (relation camera-state ((eyes symbol) (state symbol) (trouble string)) (key eyes))
      (relation look ((eyes symbol) (frame integer) (text string) (of list)) (key eyes))
      (relation learned ((eyes symbol) (name string) (num integer) (area number) (perimeter number) (features integer)
                         (m0 number) (m1 number) (m2 number)) (key eyes name num)))))")
                                                  .value()};
  Job answering;
};

TEST_F(ReplOfEyes, WhoConnectsIsToldWhyTheCameraGivesNoImages) {
  eyes_tell("(camera-state vision opening \"\")");
  const Job later = executor.spawn(lose_the_camera_later());
  EXPECT_EQ(type("(vision (connect))"), Evaluation::done);
  EXPECT_EQ(shown, "ok\n  vision has no images: the camera: /dev/video0 cannot be opened\n");
  eyes_tell("(camera-state vision open \"\")");
  type("(vision (connect))");
  EXPECT_EQ(shown, "ok\n");
}

TEST_F(ReplOfEyes, WhoConnectsToACameraThatIsSlowIsToldSo) {
  eyes_tell("(camera-state vision opening \"\")");
  type("(vision (connect))");
  EXPECT_EQ(shown, "ok\n  vision has no images yet: its camera is being opened\n");
}

TEST_F(ReplOfEyes, ObjectsAreWhereTheEyesSeeThem) {
  for (const char* name : {"circle", "cross", "square", "triangle"}) learn(name);
  eyes_tell(
      "(look vision 41 \"(TRACK 0)\" ((\"circle\" seen 0.98 (left 227.99 127.58) (range 516.46 2.1) (second \"\" 0.1))"
      " (\"cross\" lost) (\"square\" bridged 0.9 (left 10.5 20.5) (range 300.25 0.0))))");
  EXPECT_EQ(type("(objects)"), Evaluation::done);
  EXPECT_EQ(shown,
            "  circle         seen at (227.99, 127.58) px, 516 mm away, frame 41\n"
            "  cross          not seen\n"
            "  square         hidden just now, last near (10.50, 20.50) px, frame 41\n"
            "  triangle       learned; (vision (track \"triangle\")) follows it\n");
  type("(tell (agent coordinator coordinator \"here\"))");
  type("(objects)");
  EXPECT_TRUE(shown.contains("  triangle       learned; it is followed from the first goal on\n")) << shown;
}

TEST_F(ReplOfEyes, AnArmThatLearnsWhereItStandsIsNotTakenForEyes) {
  const std::unique_ptr<Board> arms_view = board.view("robot");
  runtime::AgentContext arms_context{"robot", "localhost", executor, *arms_view, Random(1)};
  runtime::Service arm(arms_context,
                       runtime::contract_from_text("(contract robot (offers (learn (variable symbol))))").value());
  const Job answering_for_it = executor.spawn([](runtime::Service& served_arm) -> Task<void> {
    const Result<void> started = co_await served_arm.start();
    EXPECT_TRUE(started.has_value());
    runtime::RequestHandler handler = [](Fact) { return say_true(); };
    const Result<void> served = co_await served_arm.serve_requests(std::move(handler));
  }(arm));
  executor.run_for(1s);
  EXPECT_EQ(type("(robot (learn p1))"), Evaluation::done);
  EXPECT_EQ(shown, "true\n");
  EXPECT_EQ(refused, 0);
}

TEST_F(ReplOfEyes, TheReasonOfAFailureStandsBelowTheText) {
  answered = list(R"x((FIND "circle" FAIL))x", "not-seen"_sym, "no mark in the image is like it");
  EXPECT_EQ(type("(vision (find \"circle\"))"), Evaluation::done);
  EXPECT_EQ(shown, "(FIND \"circle\" FAIL)\n  no mark in the image is like it\n");
}

TEST_F(ReplOfEyes, AMistypedAgentIsNamedRight) {
  EXPECT_EQ(type("(vison (find \"circle\"))"), Evaluation::malformed);
  EXPECT_TRUE(shown.contains("there is no command or agent vison; did you mean vision?")) << shown;
}

TEST_F(ReplOfEyes, HelpKnowsWhatAnAgentOffers) {
  EXPECT_EQ(type("(help vision)"), Evaluation::done);
  EXPECT_EQ(shown, "  (vision (connect))\n  (vision (find (name string)))\n");
  EXPECT_EQ(type("(help visoin)"), Evaluation::malformed);
  EXPECT_TRUE(shown.contains("did you mean vision?")) << shown;
}

TEST_F(Repl, NobodyKnowsWhyWithoutACoordinator) {
  EXPECT_EQ(type("(why)"), Evaluation::failed);
  EXPECT_EQ(shown, "no coordinator is present, so nobody knows why; (agents) shows who is\n");
}

Task<Result<Datum>> repeat(Datum operation) { co_return list(write(operation)); }

// Says every question back.
class ReplOfACoordinator : public Repl {
 protected:
  Task<void> serve_after(Duration time) {
    co_await sleep(executor, time);
    const Result<void> started = co_await coordinator.start();
    EXPECT_TRUE(started.has_value());
    const Result<void> ended = co_await coordinator.serve(repeat);
  }

  std::unique_ptr<Board> its_view = board.view("coordinator");
  runtime::AgentContext its_context{"coordinator", "localhost", executor, *its_view, Random(1)};
  runtime::Service coordinator{
      its_context, runtime::contract_from_text("(contract coordinator (offers (why-not (fact list) ...)))").value()};
};

TEST_F(ReplOfACoordinator, IsAskedWhenItsPresenceIsToldAnew) {
  const Job answering = executor.spawn(serve_after(1500ms));
  EXPECT_EQ(type("(why not (on a b))"), Evaluation::done) << shown;
}

TEST_F(ReplOfACoordinator, WhyNotAsksItAboutAGoal) {
  const Job answering = executor.spawn(serve_after(0s));
  EXPECT_EQ(type("(why not (on a b) (exists (?x OBJECT) (on ?x b)))"), Evaluation::done);
  EXPECT_EQ(shown, "(why-not (on a b) (exists (<x> OBJECT) (on <x> b)))\n");
  EXPECT_EQ(type("(why so (on a b))"), Evaluation::malformed);
}

TEST_F(Repl, AFactOfAnotherShapeIsToldInOrdinaryWords) {
  board.declare("test", {relation_from_datum(read_one("(relation note ((n integer)))").value()).value()}).value();
  type("(tell (note x))");
  EXPECT_TRUE(shown.contains("argument n of note is an integer, which x is not")) << shown;
  shown.clear();
  type("(tell (note 1 2))");
  EXPECT_TRUE(shown.contains("note has 1 argument (n), not 2")) << shown;
}

class JsonRepl : public Repl {
 protected:
  JsonRepl() : Repl(Style::json) {}
};

TEST_F(JsonRepl, TellsAsksAndRetractsInObjects) {
  type("(ask (on ?x ?y))");
  EXPECT_TRUE(shown.ends_with(",\"answers\":[]}\n")) << shown;
  type("(tell (on circle triangle))");
  EXPECT_TRUE(shown.starts_with("{\"revision\":")) << shown;
  type("(ask (on ?x ?y))");
  EXPECT_TRUE(
      shown.ends_with("\"answers\":[{\"bindings\":{\"?x\":\"circle\",\"?y\":\"triangle\"},\"facts\":[\"(on "
                      "circle triangle)\"]}]}\n"))
      << shown;
  type("(retract (on ? ?))");
  EXPECT_TRUE(shown.starts_with("{\"retracted\":1,\"revision\":")) << shown;
}

TEST_F(JsonRepl, WatchesInObjectsALineAChange) {
  type("(watch (on ?x ?y))");
  executor.run_for(1s);
  EXPECT_NE(shown.find("{\"watch\":1}\n"), std::string::npos) << shown;
  EXPECT_NE(shown.find("\"resynchronised\":true,\"removed\":[],\"added\":[]}\n"), std::string::npos) << shown;
  type("(tell (on circle triangle))");
  executor.run_for(1s);
  EXPECT_NE(shown.find("\"resynchronised\":false,\"removed\":[],\"added\":[{\"bindings\":{\"?x\":\"circle\""),
            std::string::npos)
      << shown;
}

TEST_F(JsonRepl, FailuresAreObjectsWithTheSameOutcome) {
  EXPECT_EQ(type("(tell (onn circle triangle))"), Evaluation::failed);
  EXPECT_EQ(shown,
            "{\"error\":{\"symbol\":\"undeclared-relation\",\"sentence\":\"no relation is called onn; did you mean "
            "on?\",\"subject\":\"onn\"}}\n");
  EXPECT_EQ(type("(ask (on ?x"), Evaluation::malformed);
  EXPECT_TRUE(shown.starts_with("{\"error\":{\"symbol\":\"unclosed-list\"")) << shown;
  EXPECT_EQ(type("(goal (on circle triangle))"), Evaluation::failed);
  EXPECT_TRUE(shown.starts_with("{\"error\":{\"symbol\":\"absent\"")) << shown;
}

TEST_F(Repl, ACommandNeedsNoParenthesesOfItsOwn) {
  EXPECT_EQ(type("help"), Evaluation::done);
  for (const Command& command : interpreter.commands()) {
    EXPECT_NE(shown.find(command.usage), std::string::npos) << command.name;
  }
  EXPECT_NE(shown.find("(robot (get-control))"), std::string::npos) << shown;
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

TEST_F(Repl, FindsWhoIsBoundOfAKindByProperties) {
  EXPECT_EQ(type("(find robot)"), Evaluation::failed);
  EXPECT_EQ(
      type("(declare (relation bound ((parent list) (name symbol) (kind symbol) (agent symbol)) (key parent name)))"),
      Evaluation::done);
  EXPECT_EQ(type("(declare (relation property ((agent symbol) (name symbol) (value datum)) (key agent name)))"),
            Evaluation::done);
  for (const char* fact :
       {"(agent left robot \"bench\")", "(agent right robot \"desk\")", "(bound (cell arms) left robot left)",
        "(bound (cell arms) right robot right)", "(property left reach 560)", "(property right reach 1350)"}) {
    EXPECT_EQ(type(std::string("(tell ") + fact + ")"), Evaluation::done) << shown;
  }
  EXPECT_EQ(type("(find robot (reach > 600) (host ?))"), Evaluation::done);
  EXPECT_EQ(shown, "  right as cell/arms/right: reach 1350, host desk\n");
  EXPECT_EQ(type("(tell (bound (cell hosts bench) left robot left))"), Evaluation::done);
  EXPECT_EQ(type("(find robot (reach <= 560) (host = bench))"), Evaluation::done);
  EXPECT_EQ(shown, "  left as cell/arms/left, cell/hosts/bench/left: reach 560, host bench\n");
  EXPECT_EQ(type("(find robot (reach > 2000))"), Evaluation::failed);
  EXPECT_EQ(type("(find robot (payload ?))"), Evaluation::failed);
  EXPECT_EQ(type("(find robot (reach about 600))"), Evaluation::malformed);
}

TEST_F(Repl, BindsNamesAndSaysWhoHasThem) {
  type("(tell (agent arm-1 robot \"bench\"))");
  type("(tell (agent arm-2 robot \"bench\"))");
  EXPECT_EQ(type("(bind (left) arm)"), Evaluation::failed);
  EXPECT_EQ(shown, "no agent arm is present; did you mean arm-1?\n");
  EXPECT_EQ(type("(bind (lab left) arm-1)"), Evaluation::failed);
  EXPECT_TRUE(shown.starts_with("there is no context for lab/left")) << shown;
  EXPECT_EQ(type("(tell (context () lab)) (bind (lab left) arm-1)"), Evaluation::done) << shown;
  EXPECT_EQ(type("(bind (lab left) arm-2)"), Evaluation::failed);
  EXPECT_EQ(type("(resolve (lab left))"), Evaluation::done);
  EXPECT_EQ(shown, "arm-1 (robot)\n");
  EXPECT_EQ(type("(rebind (lab left) arm-2)"), Evaluation::done);
  EXPECT_EQ(type("(list)"), Evaluation::done);
  EXPECT_EQ(shown, "  lab/\n");
  EXPECT_EQ(type("(list (lab))"), Evaluation::done);
  EXPECT_EQ(shown, "  left: arm-2 (robot)\n");
  EXPECT_EQ(type("(unbind (lab left))"), Evaluation::done);
  EXPECT_EQ(type("(unbind (lab left))"), Evaluation::failed);
  EXPECT_EQ(type("(list (lab))"), Evaluation::done);
  EXPECT_EQ(shown, "nothing is bound there\n");
  EXPECT_EQ(type("(resolve lab left)"), Evaluation::malformed);
  EXPECT_EQ(type("(list (lab 3))"), Evaluation::malformed);
}

// Whatever a prompt is called: all of them are the client `prompt`.
TEST_F(Repl, APromptsCoordinatorIsWired) {
  type("(tell (agent coordinator coordinator \"bench\"))");
  type("(tell (agent boss coordinator \"bench\"))");
  EXPECT_EQ(type("(wire)"), Evaluation::done);
  EXPECT_EQ(shown, "  prompt coordinator: coordinator\n");
  EXPECT_EQ(type("(wire prompt coordinator boss)"), Evaluation::done) << shown;
  EXPECT_EQ(type("(wire)"), Evaluation::done);
  EXPECT_EQ(shown, "  prompt coordinator: boss\n");
  type("(cancel)");
  EXPECT_TRUE(shown.starts_with("boss did not answer")) << shown;
  EXPECT_EQ(type("(wire prompt coordinator)"), Evaluation::done);
  EXPECT_EQ(type("(wire)"), Evaluation::done);
  EXPECT_EQ(shown, "  prompt coordinator: coordinator\n");
}

}  // namespace
}  // namespace pizarra::repl
