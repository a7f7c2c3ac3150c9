#include "agents/speech/speech_agent.hpp"

#include "tests/agents/robot/robot_fixture.hpp"

namespace pizarra::speech {
namespace {

// The speech agent beside a robot agent, on one board.
class Speech : public robot::Robot {
 protected:
  void SetUp() override {
    robot::Robot::SetUp();
    view = board.view("speech");
    agent.emplace(runtime::AgentContext{"speech", "localhost", executor, *view, Random(1)});
    job = executor.spawn([](SpeechAgent& speech) -> Task<void> {
      const Result<void> ended = co_await speech.run();
      EXPECT_TRUE(ended) << ended.error().sentence;
    }(*agent));
    executor.run_for(1s);
  }
  std::string say(std::string_view sentence) {
    const std::string id = fmt::format("s{}", ++asked);
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), "speech"_sym, list("say"_sym, Datum::string(sentence))));
    EXPECT_TRUE(board.transact("user", request));
    executor.run_until([&] { return !reply(id).empty(); });
    return reply(id);
  }

  std::unique_ptr<Board> view;
  std::optional<SpeechAgent> agent;
  Job job;
};

TEST_F(Speech, SaidMovesAreTheRobotsOperations) {
  const Eigen::Vector3d before = point();
  EXPECT_EQ(say("Move left 5 centimetres."), "(ok \"(move-h left 50)\" true)");
  EXPECT_LT((point() - before - Eigen::Vector3d(0, -50, 0)).norm(), 0.01);
  EXPECT_EQ(say("please move the arm down 1.5 cm"), "(ok \"(move-v down 15.0)\" true)");
  EXPECT_LT((point() - before - Eigen::Vector3d(0, -50, -15)).norm(), 0.01);
}

TEST_F(Speech, PlacesAreRememberedByName) {
  const Eigen::Vector3d before = point();
  EXPECT_EQ(say("Remember this as above"), "(ok \"(learn above)\" true)");
  say("turn right 20 degrees");
  EXPECT_EQ(say("Go to above!"), "(ok \"(goto above)\" true)");
  EXPECT_LT((point() - before).norm(), 0.01);
}

TEST_F(Speech, WhatTheArmRefusesIsAnsweredAsTheArmSaysIt) {
  EXPECT_EQ(robot::form(say("go to nowhere"))[1].text(), "unknown-variable");
  EXPECT_EQ(say("move up 5 metres"), "(ok \"(move-v up 5000)\" true)") << "it goes as far as it can";
  EXPECT_EQ(say("move up 5 metres"), "(ok \"(move-v up 5000)\" false)") << "it stands there already";
}

TEST_F(Speech, WhatIsNotUnderstoodMovesNothingAndNamesTheWord) {
  const int moves = arm.moves;
  const Datum answer = robot::form(say("mvoe left 5 cm"));
  EXPECT_EQ(answer[1].text(), "not-understood");
  EXPECT_NE(answer[2].text().find("the nearest is move"), std::string::npos);
  EXPECT_EQ(robot::form(say("))((; drop table"))[1].text(), "not-understood");
  EXPECT_EQ(robot::form(say(""))[1].text(), "not-understood");
  EXPECT_EQ(robot::form(say(std::string(100'000, 'x')))[0].text(), "fail");
  EXPECT_EQ(arm.moves, moves);
}

// Whoever pursues goals here keeps what it was asked.
TEST_F(Speech, ObjectsAreHandledByGoals) {
  const std::unique_ptr<Board> other = board.view("coordinator");
  runtime::AgentContext context{"coordinator", "localhost", executor, *other, Random(1)};
  runtime::Service service(
      context,
      runtime::contract_from_text("(contract coordinator (offers (goal (fact list) ...)) (posts) (reads))").value());
  std::string asked_for;
  const Job served = executor.spawn([](runtime::Service& goals, std::string& heard) -> Task<void> {
    const Result<void> started = co_await goals.start();
    EXPECT_TRUE(started);
    runtime::Handler handler = [&heard](Datum operation) -> Task<Result<Datum>> {
      heard = write(operation);
      co_return list(1);
    };
    const Result<void> ended = co_await goals.serve(std::move(handler));
    EXPECT_TRUE(ended);
  }(service, asked_for));
  executor.run_for(1s);
  EXPECT_EQ(say("Put the circle on the square."), "(ok \"(goal (on circle square))\" 1)");
  EXPECT_EQ(asked_for, "(goal (on circle square))");
  EXPECT_EQ(say("pick up the lid"), "(ok \"(goal (holding lid))\" 1)");
}

}  // namespace
}  // namespace pizarra::speech
