// What happens beside a motion: other requests, stops, deaths, a controller that goes away.

#include "tests/agents/robot/robot_fixture.hpp"
#include "tests/blackboard/troubled_disk.hpp"

namespace pizarra::robot {
namespace {

TEST_F(Robot, OneMotionAtATimeButMonitoredMeanwhile) {
  call("(speed 10)");
  const std::string turning = ask("(turn right 90)");
  executor.run_for(1s);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot moving \"(turn right 90)\")");
  EXPECT_EQ(refusal("(home)"), "busy");
  EXPECT_EQ(refusal("(gripper 10)"), "busy");
  EXPECT_EQ(call("(finish report)"), "(ok false)");
  EXPECT_EQ(call("(get-status)"), "(ok \"(turn right 90)\")");
  EXPECT_EQ(call("(monitor)").substr(0, 4), "(ok ");
  EXPECT_EQ(reply(turning), "");
  executor.run_for(10s);
  EXPECT_EQ(reply(turning), "(ok true)");
  EXPECT_EQ(call("(finish report)"), "(ok true)");
}

TEST_F(Robot, StopEndsTheMotionAndItsCallerHearsSo) {
  call("(speed 10)");
  const std::string turning = ask("(turn right 90)");
  executor.run_for(1s);
  EXPECT_EQ(call("(finish stop)"), "(ok true)");
  EXPECT_EQ(form(reply(turning))[1].text(), "stopped");
  EXPECT_FALSE(arm.moving());
  EXPECT_GT(arm.at()[0], 20);
  EXPECT_LT(arm.at()[0], 30);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot stopped \"(turn right 90)\")");
  EXPECT_EQ(call("(turn left 5)"), "(ok true)") << "a stop does not outlast its motion";
}

TEST_F(Robot, StopAskedTogetherWithAMotionIsNotLost) {
  call("(speed 10)");
  const std::string turning = ask("(turn right 90)");
  const std::string stopping = ask("(finish stop)");
  executor.run_for(1s);
  EXPECT_EQ(form(reply(turning))[1].text(), "stopped");
  EXPECT_EQ(reply(stopping), "(ok true)");
  EXPECT_FALSE(arm.moving());
  EXPECT_LT(arm.at()[0], 2);
}

TEST_F(Robot, AStopThatNamesARequestEndsItsMotionAndNoOther) {
  call("(speed 10)");
  const std::string turning = ask("(turn right 90)", "turning");
  executor.run_for(1s);
  EXPECT_EQ(refusal("(finish stop another)"), "busy");
  EXPECT_EQ(call("(finish report another)"), "(ok true)");
  EXPECT_EQ(call("(finish report turning)"), "(ok false)");
  EXPECT_TRUE(arm.moving());
  EXPECT_EQ(call("(finish stop turning)"), "(ok true)");
  EXPECT_EQ(reply(turning), "(fail stopped \"the motion was stopped before its end\" (finish stop turning))");
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(call("(finish stop turning)"), "(ok true)") << "it has ended";
}

TEST_F(Robot, APersonsStopDuringANamedOneIsTheReason) {
  call("(speed 10)");
  const std::string turning = ask("(turn right 90)", "turning");
  executor.run_for(1s);
  ask("(finish stop turning)");
  Transaction stop;
  stop.tell(form("(stop anna \"wait\")"));
  ASSERT_TRUE(board.transact("anna", stop));
  executor.run_for(1s);
  EXPECT_EQ(form(reply(turning))[3], form("(stop anna \"wait\")"));
}

TEST_F(Robot, StopAtRestDoesNothing) {
  EXPECT_EQ(call("(finish stop)"), "(ok true)");
  EXPECT_EQ(call("(turn right 5)"), "(ok true)");
}

TEST_F(Robot, StoppedFingersStayWhereTheyAre) {
  const std::string opening = ask("(gripper 0)");
  executor.run_for(300ms);
  EXPECT_EQ(call("(finish stop)"), "(ok true)");
  EXPECT_EQ(form(reply(opening))[1].text(), "stopped");
  const double stands = arm.opening();
  EXPECT_GT(stands, 30);
  executor.run_for(1s);
  EXPECT_EQ(arm.opening(), stands);
}

TEST_F(Robot, SameRequestIsDoneOnce) {
  ask("(turn right 10)", "twice");
  executor.run_for(2s);
  EXPECT_EQ(reply("twice"), "(ok true)");
  ask("(turn right 10)", "twice");
  executor.run_for(2s);
  EXPECT_EQ(arm.moves, 1);
  EXPECT_NEAR(arm.at()[0], 10, 1e-9);
}

TEST_F(Robot, RestartedAgentStopsTheArmAtOnceAndSaysSo) {
  call("(speed 1)");
  ask("(turn right 90)", "dropped");
  executor.run_for(1s);
  life.reset();
  executor.run_for(500ms);
  EXPECT_TRUE(arm.moving()) << "the controller goes on without its agent";
  begin();
  executor.run_for(50ms);
  EXPECT_FALSE(arm.moving()) << "whoever still has its name";
  executor.run_for(3s);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot stopped \"STOPPED_AT_RESTART\")");
}

TEST_F(Robot, StopsTheMotionInHandBeforeItsProcessEnds) {
  call("(speed 1)");
  const std::string cut_off = ask("(turn right 90)");
  executor.run_for(1s);
  EXPECT_TRUE(arm.moving());
  const Job standing = executor.spawn(life->agent().stand_still());
  executor.run_for(500ms);
  EXPECT_TRUE(standing.done());
  EXPECT_FALSE(arm.moving());
  EXPECT_TRUE(reply(cut_off).starts_with("(fail stopped \"the robot agent was ended")) << reply(cut_off);
}

TEST_F(Robot, HasNothingToStopAtRestBeforeItsProcessEnds) {
  const Job standing = executor.spawn(life->agent().stand_still());
  executor.run_for(1ms);
  EXPECT_TRUE(standing.done());
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
}

TEST_F(Robot, WhatAPersonMovesByThePendantIsLetAlone) {
  call("(speed 1)");
  ask("(turn right 90)");
  executor.run_for(1s);
  life.reset();
  arm.trouble = arm::ArmTrouble{arm::ArmTrouble::Kind::stopped, {"not-in-control", "the pendant has control", {}, {}}};
  begin();
  executor.run_for(3s);
  EXPECT_TRUE(arm.moving());
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot stopped \"the pendant has control\")");
}

TEST_F(Robot, RequestOfAnAgentThatDiedIsAnsweredOnceAndNothingGoesOn) {
  call("(speed 5)");
  for (const std::string_view operation : {"(turn right 90)", "(gripper 0)"}) {
    const std::string cut_off = ask(operation);
    executor.run_for(200ms);
    life.reset();
    begin();
    executor.run_for(5s);
    EXPECT_TRUE(reply(cut_off).starts_with("(fail stopped \"the robot agent was restarted")) << reply(cut_off);
    const arm::Joints stands = arm.at();
    executor.run_for(10s);
    EXPECT_EQ(arm.at(), stands) << operation;
  }
  EXPECT_EQ(arm.moves, 1);
  EXPECT_EQ(call("(turn left 5)"), "(ok true)");
}

TEST_F(Robot, WhatStandsOnTheBoardIsDoneThoughItMayNotLast) {
  life.reset();
  executor.run_for(3s);
  Disk disk = Disk::full;
  life.emplace(executor, std::make_unique<TroubledDisk>(board, "robot", disk), arm);
  executor.run_for(1s);
  EXPECT_EQ(refusal("(turn right 10)"), "journal-full");
  disk = Disk::failing;
  EXPECT_EQ(call("(turn right 10)"), "(ok true)");
  EXPECT_NEAR(arm.at()[0], 10, 1e-9);
  EXPECT_EQ(call("(learn here)"), "(ok true)");
  EXPECT_EQ(call("(speed 50)"), "(ok true)");
  EXPECT_EQ(fact("(robot-speed robot ?)"), "(robot-speed robot 50.0)");
}

// How a motion ended is told before its reply, and its agent may die between the two.
TEST_F(Robot, MotionThatHadEndedIsAnsweredByTheSuccessorAndNotDoneAgain) {
  life.reset();
  executor.run_for(3s);
  ask("(turn right 10)", "ended");
  ask("(turn right 20)", "new");
  Transaction earlier;
  earlier.tell(form("(robot-motion robot ended (ok true))"));
  ASSERT_TRUE(board.transact("robot", earlier));
  begin();
  executor.run_for(5s);
  EXPECT_EQ(reply("ended"), "(ok true)");
  EXPECT_EQ(reply("new"), "(ok true)");
  EXPECT_NEAR(arm.at()[0], 20, 1e-9);
}

TEST_F(Robot, ArmsOnOneBoardTellSideBySideAndRememberTheirOwn) {
  FakeArm other_arm{executor};
  std::optional<RobotLife> other;
  const auto begin_other = [&] { other.emplace(executor, board, other_arm, arm::crs_f3(), RobotOptions(), "other"); };
  begin_other();
  executor.run_for(1s);
  call("(speed 30)");
  call("(learn here)");
  const std::string turned = ask("(turn right 24)", "", "other");
  executor.run_for(10s);
  EXPECT_EQ(reply(turned), "(ok true)");
  EXPECT_EQ(first("(arm-joints robot ?)", 2), "(0.0 0.0 -90.0 0.0 -90.0 0.0 2500.0)");
  EXPECT_EQ(first("(arm-joints other ?)", 2), "(24.0 0.0 -90.0 0.0 -90.0 0.0 2500.0)");
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
  EXPECT_EQ(fact("(arm other ? ?)"), "(arm other idle \"(turn right 24)\")");
  ask("(speed 50)", "", "other");
  executor.run_for(100ms);
  EXPECT_EQ(fact("(robot-speed robot ?)"), "(robot-speed robot 30.0)");
  EXPECT_EQ(fact("(robot-speed other ?)"), "(robot-speed other 50.0)");
  other.reset();
  begin_other();
  executor.run_for(3s);
  const std::string unknown = ask("(goto here)", "", "other");
  executor.run_for(1s);
  EXPECT_EQ(form(reply(unknown))[1].text(), "unknown-variable") << "the other arm's";
}

TEST_F(Robot, RestartedAgentKnowsItsVariablesAndSpeed) {
  call("(turn right 10)");
  call("(learn shelf)");
  call("(speed 50)");
  call("(ready)");
  life.reset();
  begin();
  executor.run_for(5s);
  EXPECT_EQ(call("(goto shelf)"), "(ok true)");
  EXPECT_NEAR(arm.at()[0], 10, 1e-9);
  EXPECT_EQ(arm.last_speed, 0.5);
}

TEST_F(Robot, ControllerThatGoesAwayIsAFaultUntilItIsBack) {
  arm.plugged = false;
  executor.run_for(1s);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot fault \"the arm cannot be commanded: the plug is pulled\")");
  EXPECT_EQ(call("(get-status)"), "(ok \"NO_ACTION\")");
  EXPECT_EQ(refusal("(home)"), "disconnected");
  EXPECT_EQ(refusal("(monitor)"), "disconnected");
  arm.plugged = true;
  executor.run_for(2s);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
  EXPECT_EQ(arm.controls, 1) << "nobody asked for it";
  EXPECT_EQ(call("(home)"), "(ok true)");
}

TEST_F(Robot, WhereAnArmIsIsNotSaidWhileItsControllerIsAway) {
  arm.gripped = true;
  executor.run_for(200ms);
  const std::string_view told[] = {"(arm-pose robot ? ? ? ? ? ?)", "(arm-joints robot ?)", "(gripper robot ?)",
                                   "(gripped robot ?)"};
  for (const std::string_view pattern : told) EXPECT_NE(fact(pattern), "") << pattern;
  arm.plugged = false;
  executor.run_for(3s);
  for (const std::string_view pattern : told) EXPECT_EQ(fact(pattern), "") << pattern;
  arm.plugged = true;
  executor.run_for(2s);
  for (const std::string_view pattern : told) EXPECT_NE(fact(pattern), "") << pattern;
}

TEST_F(Robot, PlugPulledDuringAMotionFailsItOnce) {
  call("(speed 5)");
  const std::string turning = ask("(turn right 90)");
  executor.run_for(500ms);
  arm.plugged = false;
  executor.run_for(1s);
  EXPECT_EQ(reply(turning), "") << "a short silence is waited out";
  executor.run_for(3s);
  EXPECT_EQ(form(reply(turning))[1].text(), "disconnected");
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot fault \"the arm cannot be commanded: the plug is pulled\")");
}

TEST_F(Robot, ControlTakenAwayByThePendantIsTakenBackOnlyWhenAskedFor) {
  for (const std::string_view operation : {"(turn right 5)", "(gripper 0)"}) {
    arm.in_control = false;
    EXPECT_EQ(refusal(operation), "not-in-control") << operation;
    EXPECT_FALSE(arm.in_control);
    EXPECT_EQ(call("(get-control)"), "(ok true)");
    EXPECT_EQ(call(operation), "(ok true)") << operation;
  }
  EXPECT_EQ(arm.controls, 3);
}

TEST_F(Robot, ControlIsNotTakenInTheMiddleOfAMotion) {
  ask("(turn right 90)");
  executor.run_for(300ms);
  EXPECT_EQ(refusal("(get-control)"), "busy");
  EXPECT_EQ(arm.controls, 1);
}

TEST_F(Robot, StopIsObeyedAlthoughControlWasTakenAway) {
  const std::string turning = ask("(turn right 90)");
  executor.run_for(300ms);
  arm.in_control = false;
  EXPECT_EQ(call("(finish stop)"), "(ok true)");
  EXPECT_EQ(form(reply(turning))[1].text(), "stopped");
  EXPECT_FALSE(arm.moving());
  EXPECT_EQ(arm.controls, 1);
}

TEST_F(Robot, ControllerThatGivesNoControlSaysSo) {
  arm.in_control = false;
  arm.gives_control = false;
  EXPECT_EQ(refusal("(get-control)"), "not-in-control");
  EXPECT_EQ(refusal("(gripper 0)"), "not-in-control");
  EXPECT_EQ(arm.controls, 2);
}

TEST_F(Robot, ControlThatIsReleasedMovesNothingUntilItIsTakenBack) {
  EXPECT_EQ(call("(release-control)"), "(ok true)");
  EXPECT_FALSE(arm.in_control);
  EXPECT_EQ(fact("(robot-released robot ?)"), "(robot-released robot user)");
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot stopped \"(release-control)\")");
  // As where the person at the pendant switches the servos on.
  arm.in_control = true;
  for (const std::string_view operation : {"(turn right 5)", "(gripper 0)", "(do-action \"(track 10)\")"}) {
    EXPECT_EQ(refusal(operation), "not-in-control") << operation;
  }
  EXPECT_EQ(arm.moves, 0);
  EXPECT_EQ(form(call("(monitor)"))[0], "ok"_sym);
  EXPECT_EQ(call("(speed 50)"), "(ok true)");
  EXPECT_EQ(call("(get-control)"), "(ok true)");
  EXPECT_EQ(fact("(robot-released robot ?)"), "");
  EXPECT_EQ(call("(turn right 5)"), "(ok true)");
}

TEST_F(Robot, ControlIsNotReleasedInTheMiddleOfAMotion) {
  ask("(turn right 90)");
  executor.run_for(300ms);
  EXPECT_EQ(refusal("(release-control)"), "busy");
  EXPECT_TRUE(arm.in_control);
  EXPECT_EQ(fact("(robot-released robot ?)"), "");
}

TEST_F(Robot, ASuccessorLeavesReleasedControlAlone) {
  ASSERT_EQ(call("(release-control)"), "(ok true)");
  life.reset();
  executor.run_for(30s);
  begin();
  executor.run_for(1s);
  EXPECT_EQ(arm.controls, 1) << "nobody asked for it";
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot stopped \"(release-control)\")");
  EXPECT_EQ(refusal("(home)"), "not-in-control");
  EXPECT_EQ(call("(get-control)"), "(ok true)");
  EXPECT_EQ(call("(home)"), "(ok true)");
}

TEST(RobotStart, AnArmThatNobodyKnowsIsRefused) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  FakeArm arm(executor);
  arm.type = "typewriter";
  RobotLife life(executor, board, arm);
  executor.run_for(1s);
  ASSERT_TRUE(life.ended);
  ASSERT_FALSE(*life.ended);
  EXPECT_EQ(life.ended->error().symbol, "unknown-arm");
}

TEST(RobotStart, AControllerThatStartsLaterIsWaitedFor) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  FakeArm arm(executor);
  arm.plugged = false;
  RobotLife life(executor, board, arm);
  executor.run_for(3s);
  arm.plugged = true;
  executor.run_for(1s);
  EXPECT_FALSE(life.ended);
  EXPECT_EQ(arm.controls, 1);
}

}  // namespace
}  // namespace pizarra::robot
