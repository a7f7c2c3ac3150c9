#include "agents/robot/guard.hpp"
#include "tests/agents/robot/robot_fixture.hpp"
#include "tests/blackboard/passing_board.hpp"
#include "tests/run_task.hpp"

// The events that stop the arm without its commander being asked, and the choice of the commander.

namespace pizarra::robot {
namespace {

class RobotSafety : public Robot {
 protected:
  void tell(std::string_view teller, std::string_view fact, LeaseId lease = 0) {
    Transaction telling;
    telling.tell(form(fact), {}, lease);
    const Result<Revision> told = board.transact(std::string(teller), telling);
    ASSERT_TRUE(told) << told.error().sentence;
  }
  void retract(std::string_view pattern) {
    Transaction retraction;
    retraction.retract(form(pattern));
    ASSERT_TRUE(board.transact("user", retraction));
  }
  // A motion in hand that `teller` asked for; its reply is under the id that is answered.
  std::string begin_motion(std::string_view teller = "user") {
    std::string id = fmt::format("m{}", ++asked);
    tell(teller, fmt::format("(request {} robot (turn right 150))", id));
    executor.run_for(200ms);
    EXPECT_TRUE(arm.moving());
    return id;
  }
  // The controller moves the arm by itself, as one to which an order came late.
  void stray() {
    arm::Joints there = arm.at();
    there[0] += 150;
    ASSERT_TRUE(pizarra::run(executor, arm.start_move({there}, 0.3)));
    ASSERT_TRUE(arm.moving());
  }
};

TEST_F(RobotSafety, WhatMovesWithNoMotionInHandIsStoppedAndToldSo) {
  stray();
  executor.run_for(200ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot stopped \"MOVED_BY_ITSELF\")");
  EXPECT_EQ(call("(ready)"), "(ok true)");
}

TEST_F(RobotSafety, WhatAPersonMovesByThePendantBetweenMotionsIsLetAlone) {
  arm.trouble = arm::ArmTrouble{arm::ArmTrouble::Kind::stopped, {"not-in-control", "the pendant has control", {}, {}}};
  stray();
  executor.run_for(200ms);
  tell("passer-by", "(stop passer-by \"mind the dog\")");
  executor.run_for(200ms);
  EXPECT_TRUE(arm.moving());
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot stopped \"the pendant has control\")");
}

TEST_F(RobotSafety, AStopStopsAtOnceWhatMovesWithNoMotionInHandToo) {
  life.reset();
  executor.run_for(3s);
  life.emplace(executor, board, arm, arm::crs_f3(), RobotOptions{.told_per_s = 1});
  executor.run_for(5s);
  stray();
  tell("passer-by", "(stop passer-by \"mind the dog\")");
  executor.run_for(20ms);
  EXPECT_FALSE(arm.moving()) << "long before it is looked at again";
}

TEST_F(RobotSafety, StopFactFromAnyoneStopsTheMotionAndSaysWhoAndWhy) {
  const std::string id = begin_motion();
  tell("passer-by", "(stop passer-by \"mind the dog\")");
  executor.run_for(100ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(reply(id), "(fail stopped \"passer-by says stop: mind the dog\" (stop passer-by \"mind the dog\"))");
  EXPECT_EQ(first("(arm robot ?state ?action)", 2), "stopped");
}

TEST_F(RobotSafety, NothingMovesWhileAStopStandsNorByItselfAfterwards) {
  begin_motion();
  tell("passer-by", "(stop passer-by \"wait\")");
  executor.run_for(200ms);
  EXPECT_EQ(refusal("(home)"), "halted");
  EXPECT_EQ(refusal("(gripper 20)"), "halted");
  EXPECT_EQ(call("(monitor)").substr(0, 4), "(ok ");
  retract("(stop passer-by ?)");
  executor.run_for(2s);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(call("(home)"), "(ok true)");
}

TEST_F(RobotSafety, FingersStopToo) {
  const std::string id = ask("(gripper 0)");
  executor.run_for(200ms);
  tell("passer-by", "(stop passer-by \"my finger\")");
  executor.run_for(200ms);
  EXPECT_EQ(form(reply(id))[1].text(), "stopped");
  EXPECT_GT(arm.opening(), 20);
}

TEST_F(RobotSafety, CommandsAreOneClientsAndMonitoringEverybodys) {
  const LeaseId lease = board.lease(10s).value();
  tell("anna", "(agent anna person \"here\")", lease);
  tell("anna", "(commander robot anna)", lease);
  tell("user", "(agent user person \"here\")", board.lease(10s).value());
  tell("user", "(commander robot user)");
  executor.run_for(100ms);
  EXPECT_EQ(refusal("(home)"), "not-commander");
  EXPECT_EQ(call("(get-status)"), "(ok \"NO_ACTION\")");
  begin_motion("anna");
  EXPECT_EQ(call("(finish stop)"), "(ok true)");
  ASSERT_TRUE(board.release(lease));
  executor.run_for(100ms);
  EXPECT_EQ(call("(home)"), "(ok true)") << "user is the next in line";
}

TEST_F(RobotSafety, WhatTheRobotIsToDoOrKnowIsItsCommandersToSay) {
  const LeaseId lease = board.lease(10s).value();
  tell("anna", "(agent anna person \"here\")", lease);
  tell("anna", "(commander robot anna)", lease);
  executor.run_for(100ms);
  for (const std::string_view operation : {"(speed 3)", "(learn p1)", "(gripper 20)", "(home)", "(get-control)"}) {
    EXPECT_EQ(refusal(operation), "not-commander") << operation;
  }
  for (const std::string_view operation : {"(get-status)", "(monitor)", "(finish report)", "(finish stop)"}) {
    EXPECT_TRUE(call(operation).starts_with("(ok ")) << operation;
  }
  EXPECT_EQ(fact("(robot-speed robot ?)"), "");
  EXPECT_EQ(fact("(robot-variable robot ? ?)"), "");
}

TEST_F(RobotSafety, ACommanderThatIsNotPresentCommandsNobody) {
  tell("anna", "(commander robot anna)");
  executor.run_for(100ms);
  EXPECT_EQ(call("(home)"), "(ok true)");
}

TEST_F(RobotSafety, WhoCommandsWithoutBeingPresentIsToldSo) {
  tell("user", "(commander robot user)");
  executor.run_for(100ms);
  EXPECT_EQ(call("(home)"),
            "(fail not-present \"user says that it commands the arm and is not present: there is no (agent user ...)\" "
            "user)");
  EXPECT_EQ(arm.moves, 0);
  tell("user", "(agent user person \"here\")", board.lease(10s).value());
  executor.run_for(100ms);
  EXPECT_EQ(call("(home)"), "(ok true)");
}

TEST_F(RobotSafety, AMotionEndsWithinATenthOfASecondWhenAnotherComesToCommand) {
  const std::string id = begin_motion();
  tell("anna", "(commander robot anna)");
  executor.run_for(100ms);
  EXPECT_TRUE(arm.moving()) << "she is not present";
  tell("anna", "(agent anna person \"here\")", board.lease(10s).value());
  executor.run_for(100ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(reply(id), "(fail stopped \"anna commands the arm now\" anna)");
}

TEST_F(RobotSafety, WhoComesToCommandWhileTheCommanderMovesTheArmWaits) {
  tell("anna", "(agent anna person \"here\")", board.lease(10s).value());
  tell("anna", "(commander robot anna)");
  const std::string id = begin_motion("anna");
  tell("user", "(agent user person \"here\")", board.lease(10s).value());
  tell("user", "(commander robot user)");
  executor.run_for(200ms);
  EXPECT_TRUE(arm.moving());
  retract("(commander robot anna)");
  executor.run_for(100ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(reply(id), "(fail stopped \"anna, who commanded this, is gone\" anna)");
}

TEST_F(RobotSafety, AStopThatStandsAtTheStartIsKnownBeforeTheFirstRequest) {
  life.reset();
  executor.run_for(3s);
  tell("passer-by", "(stop passer-by \"wait\")");
  const std::string id = ask("(home)");
  begin();
  executor.run_for(20s);
  EXPECT_TRUE(reply(id).starts_with("(fail halted ")) << reply(id);
  EXPECT_EQ(arm.moves, 0);
}

TEST_F(RobotSafety, WhatIsToldOfTheArmGoesWithItsAgent) {
  ASSERT_NE(fact("(arm robot ? ?)"), "");
  life.reset();
  executor.run_for(3s);
  for (const std::string_view told :
       {"(arm robot ? ?)", "(arm-pose robot ? ? ? ? ? ?)", "(arm-joints robot ?)", "(gripper robot ?)"}) {
    EXPECT_EQ(fact(told), "");
  }
  begin();
  executor.run_for(1s);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
}

TEST_F(RobotSafety, NobodyMakesAnotherTheCommander) {
  tell("mallory", "(commander robot anna)");
  executor.run_for(100ms);
  EXPECT_EQ(call("(home)"), "(ok true)");
}

TEST_F(RobotSafety, CommanderWhoseLeaseLapsesStopsTheArmWithinATenthOfASecond) {
  const LeaseId lease = board.lease(10s).value();
  tell("anna", "(agent anna person \"here\")", board.lease(10s).value());
  tell("anna", "(commander robot anna)", lease);
  const std::string id = begin_motion("anna");
  ASSERT_TRUE(board.release(lease));
  executor.run_for(100ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(reply(id), "(fail stopped \"anna, who commanded this, is gone\" anna)");
}

TEST_F(RobotSafety, ClientThatIsNoLongerPresentStopsTheArm) {
  const LeaseId lease = board.lease(10s).value();
  tell("anna", "(agent anna person \"here\")", lease);
  executor.run_for(100ms);
  const std::string id = begin_motion("anna");
  ASSERT_TRUE(board.release(lease));
  executor.run_for(100ms);
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(form(reply(id))[1].text(), "stopped");
}

// A board that goes silent: calls wait for as long as it is muted.
class MutedBoard : public PassingBoard {
 public:
  MutedBoard(Executor& executor, std::unique_ptr<Board> board, const bool& muted)
      : PassingBoard(std::move(board)), executor_(executor), muted_(muted) {}

  Task<Result<Revision>> transact(Transaction transaction) override {
    co_await heard();
    co_return co_await PassingBoard::transact(std::move(transaction));
  }
  Task<Result<void>> renew(LeaseId lease) override {
    co_await heard();
    co_return co_await PassingBoard::renew(lease);
  }

 private:
  Task<void> heard() {
    while (muted_) co_await sleep(executor_, 10ms);
  }
  Executor& executor_;
  const bool& muted_;
};

class RobotBeforeSilence : public RobotSafety {
 protected:
  void SetUp() override {
    life.emplace(executor, std::make_unique<MutedBoard>(executor, board.view("robot"), muted), arm);
    executor.run_for(1s);
  }
  bool muted = false;
};

TEST_F(RobotBeforeSilence, BoardThatFallsSilentStopsTheArmWithinATenthOfASecond) {
  const std::string id = begin_motion();
  muted = true;
  executor.run_for(100ms);
  EXPECT_FALSE(arm.moving());
  const arm::Joints stood = arm.at();
  muted = false;
  executor.run_for(1s);
  EXPECT_EQ(reply(id), "(fail stopped \"the board has not answered for 80 ms\" (silent board))");
  EXPECT_EQ(arm.at(), stood) << "nothing goes on before it is asked for";
}

// `down` ends the board and the agent at once.
TEST_F(RobotBeforeSilence, AnAgentThatIsEndedWaitsForTheArmToStandAndNotForTheBoard) {
  begin_motion();
  muted = true;
  const Job standing = executor.spawn(life->agent().stand_still());
  executor.run_for(200ms);
  EXPECT_TRUE(standing.done());
  EXPECT_FALSE(arm.moving());
}

TEST_F(RobotBeforeSilence, AJogThatItStoppedDoesNotGoOnThoughTheHandNeverLetGo) {
  int count = 0;
  const auto hold_for = [&](Duration time) {
    for (Duration held{}; held < time; held += 50ms) {
      tell("user", fmt::format("(hold robot user {})", ++count));
      executor.run_for(50ms);
    }
  };
  hold_for(50ms);
  const std::string id = ask("(jog right 600)");
  hold_for(200ms);
  EXPECT_TRUE(arm.moving());
  muted = true;
  hold_for(150ms);
  EXPECT_FALSE(arm.moving());
  const arm::Joints stood = arm.at();
  muted = false;
  hold_for(1s);
  EXPECT_EQ(reply(id), "(fail stopped \"the board has not answered for 80 ms\" (silent board))");
  EXPECT_EQ(arm.at(), stood);
}

// Between a request and its first motion lie the board's round trips.
TEST_F(RobotBeforeSilence, WhoComesToCommandBeforeTheMotionBeginsKeepsItFromBeginning) {
  muted = true;
  const std::string id = ask("(turn right 90)");
  executor.run_for(50ms);
  tell("anna", "(agent anna person \"here\")", board.lease(10s).value());
  tell("anna", "(commander robot anna)");
  executor.run_for(50ms);
  muted = false;
  executor.run_for(1s);
  EXPECT_EQ(reply(id), "(fail not-commander \"anna commands the arm\" anna)");
  EXPECT_EQ(arm.moves, 0);
}

// A line that loses one question in ten: its answer comes when it has been sent again.
class LossyBoard : public PassingBoard {
 public:
  LossyBoard(Executor& executor, std::unique_ptr<Board> board) : PassingBoard(std::move(board)), executor_(executor) {}

  Task<Result<void>> renew(LeaseId lease) override {
    const bool lost = ++asked_ % 10 == 0;
    if (lost) co_await sleep(executor_, 250ms);
    co_return co_await PassingBoard::renew(lease);
  }

 private:
  Executor& executor_;
  int asked_ = 0;
};

TEST_F(RobotSafety, QuestionThatIsLostOnTheWayStopsNoArmWhileLaterOnesAreAnswered) {
  life.reset();
  executor.run_for(3s);
  life.emplace(executor, std::make_unique<LossyBoard>(executor, board.view("robot")), arm);
  executor.run_for(1s);
  const std::string id = begin_motion();
  executor.run_for(20s);
  EXPECT_TRUE(reply(id).starts_with("(ok ")) << reply(id);
}

arm::ArmReading reading_of(const arm::Joints& joints) { return {joints, true, false, 80, false}; }

TEST(Guard, SpeedAboveAnAxisOwnIsNoticedAndItsOwnIsNot) {
  const arm::ArmModel& arm = arm::crs_f3();
  for (const double factor : {0.5, 1.0, 1.2, 2.0}) {
    Guard guard(arm);
    arm::Joints joints = arm.ready;
    std::optional<Failure> noticed;
    for (int i = 0; i < 20 && !noticed; ++i) {
      noticed = guard.look(Time{} + i * 20ms, reading_of(joints));
      joints[2] += factor * arm.axes[2].speed * 0.02;
    }
    ASSERT_EQ(noticed.has_value(), factor > Guard::speed_slack) << factor;
    if (!noticed) continue;
    EXPECT_EQ(noticed->symbol, "too-fast");
    EXPECT_EQ(noticed->subject, to_datum(3));
  }
}

TEST(Guard, AxisBeyondItsLimitsIsNamed) {
  Guard guard(arm::crs_f3());
  arm::Joints joints = arm::crs_f3().ready;
  joints[1] = 46.5;
  const std::optional<Failure> noticed = guard.look(Time{}, reading_of(joints));
  ASSERT_TRUE(noticed);
  EXPECT_EQ(noticed->symbol, "joint-limit");
  EXPECT_EQ(noticed->subject, to_datum(2));
}

TEST(Guard, RoomIsLeftByNobodyAndComeBackToByAll) {
  const arm::ArmModel& arm = arm::crs_f3();
  Guard guard(arm, WorkVolume{{200, -300, 30}, {380, 300, 700}});
  guard.begin();
  EXPECT_FALSE(guard.look(Time{}, reading_of(arm.ready)));
  arm::Joints out = arm.ready;
  out[0] = 70;
  const std::optional<Failure> noticed = guard.look(Time{} + 20ms, reading_of(out));
  ASSERT_TRUE(noticed);
  EXPECT_EQ(noticed->symbol, "out-of-room");
  guard.begin();
  EXPECT_FALSE(guard.look(Time{} + 1s, reading_of(out)));
}

TEST_F(RobotSafety, MotionOutOfTheRoomIsRefusedBeforeAnythingMoves) {
  life.reset();
  executor.run_for(3s);
  life.emplace(executor, board, arm, arm::crs_f3(), RobotOptions{.room = WorkVolume{{200, -300, 30}, {380, 300, 700}}});
  executor.run_for(1s);
  EXPECT_EQ(refusal("(extend keep-height 60)"), "out-of-room");
  EXPECT_EQ(refusal("(turn right 90)"), "out-of-room");
  EXPECT_EQ(arm.at(), arm::crs_f3().ready);
  EXPECT_EQ(call("(move-v down 50)"), "(ok true)");
}

}  // namespace
}  // namespace pizarra::robot
