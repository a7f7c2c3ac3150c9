// Every operation as an asker sees it.

#include <set>

#include "tests/agents/robot/robot_fixture.hpp"

namespace pizarra::robot {
namespace {

TEST_F(Robot, TakesControlAndTellsWhereTheArmStands) {
  EXPECT_EQ(arm.controls, 1);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
  EXPECT_EQ(fact("(arm-pose robot ? ? ? ? ? ?)"), "(arm-pose robot 370.0 0.0 410.0 180.0 0.0 0.0)");
  EXPECT_EQ(fact("(arm-joints robot ?)"), "(arm-joints robot (0.0 0.0 -90.0 0.0 -90.0 0.0 2500.0))");
  EXPECT_EQ(fact("(gripper robot ?)"), "(gripper robot 80.0)");
  EXPECT_EQ(call("(get-status)"), "(ok \"NO_ACTION\")");
}

TEST_F(Robot, ShowsAContractThatOffersAllItsOperations) {
  const Datum contract = *fact_like("(contract robot ?)");
  std::set<std::string_view> offered;
  for (const Datum& part : contract[2].items().subspan(2)) {
    if (!part.is_form("offers")) continue;
    for (const Datum& operation : part.items().subspan(1)) offered.insert(operation.head());
  }
  EXPECT_EQ(offered.size(), 21u);
  EXPECT_TRUE(offered.contains("move-to"));
  EXPECT_TRUE(offered.contains("release-control"));
  EXPECT_TRUE(offered.contains("jog"));
}

TEST_F(Robot, EveryMotionMovesTheGripCentreAsItsNameSays) {
  struct Case {
    std::string_view operation;
    Eigen::Vector3d offset;
  };
  for (const Case& given : {Case{"(move-v down 60)", {0, 0, -60}}, Case{"(move-h right 40)", {0, 40, 0}},
                            Case{"(move-h left 40)", {0, -40, 0}}, Case{"(extend keep-height 30)", {30, 0, 0}},
                            Case{"(retract 30)", {-30, 0, 0}}, Case{"(extend keep-distance 25)", {0, 0, 25}},
                            Case{"(move-v up 10)", {0, 0, 10}}, Case{"(turn-wrist right 15)", {0, 0, 0}}}) {
    const Eigen::Vector3d before = point();
    EXPECT_EQ(call(given.operation), "(ok true)") << given.operation;
    EXPECT_FALSE(arm.moving()) << "the reply comes when the move has ended";
    EXPECT_LT((point() - before - given.offset).norm(), 1e-6) << given.operation;
    EXPECT_EQ(fact("(arm robot ? ?)"), fmt::format("(arm robot idle {})", write(Datum::string(given.operation))));
    EXPECT_EQ(call("(get-status)"), fmt::format("(ok {})", write(Datum::string(given.operation))));
  }
}

TEST_F(Robot, TurnsAxisOneByHundredthsOfADegree) {
  EXPECT_EQ(call("(turn right 10.01)"), "(ok true)");
  EXPECT_NEAR(arm.at()[0], 10.01, 1e-9);
  EXPECT_EQ(call("(turn left 20)"), "(ok true)");
  EXPECT_NEAR(arm.at()[0], -9.99, 1e-9);
  EXPECT_EQ(call("(turn-ef up 5)"), "(ok true)");
  EXPECT_NEAR(arm.at()[4], -85, 1e-9);
}

TEST_F(Robot, HomeAndReadyGoToTheModelsPoses) {
  EXPECT_EQ(call("(home)"), "(ok true)");
  EXPECT_EQ(arm.at(), arm::crs_f3().home);
  EXPECT_EQ(call("(ready)"), "(ok true)");
  EXPECT_EQ(arm.at(), arm::crs_f3().ready);
}

TEST_F(Robot, SpeedIsAPartOfTheAxesSpeedAndIsRemembered) {
  EXPECT_EQ(call("(speed 10)"), "(ok true)");
  const Time begun = executor.now();
  EXPECT_EQ(call("(turn right 24)"), "(ok true)");
  EXPECT_GE(executor.now() - begun, 1000ms);
  EXPECT_LE(executor.now() - begun, 1100ms);
  EXPECT_EQ(fact("(robot-speed robot ?)"), "(robot-speed robot 10.0)");
  for (const std::string_view bad : {"(speed 0)", "(speed -5)", "(speed 101)"}) {
    EXPECT_EQ(refusal(bad), "out-of-range") << bad;
  }
}

TEST_F(Robot, GoesBackToWhatItLearned) {
  call("(move-v down 50)");
  const arm::Joints there = arm.at();
  EXPECT_EQ(call("(learn shelf)"), "(ok true)");
  call("(ready)");
  EXPECT_EQ(call("(goto shelf)"), "(ok true)");
  EXPECT_EQ(arm.at(), there);
  EXPECT_EQ(refusal("(goto shelv)"), "unknown-variable");
}

TEST_F(Robot, DoesAFreeFormAction) {
  EXPECT_EQ(call("(do-action \"(circle (450 0 200) (420 30 200) (390 0 200)) (move 400 50 150)\")"), "(ok true)");
  EXPECT_LT((point() - Eigen::Vector3d(400, 50, 150)).norm(), 1e-6);
  EXPECT_EQ(arm.moves, 1) << "one action is one motion";
  EXPECT_EQ(refusal("(do-action \"(jump)\")"), "bad-action");
}

TEST_F(Robot, GripperAnswersWhenTheFingersStandOnWhatTheyHold) {
  EXPECT_EQ(call("(gripper 20)"), "(ok true)");
  EXPECT_EQ(fact("(gripper robot ?)"), "(gripper robot 20.0)");
  EXPECT_EQ(call("(gripper 80)"), "(ok true)");
  arm.between_fingers_mm = 60;
  EXPECT_EQ(call("(gripper 40)"), "(ok true)");
  EXPECT_EQ(fact("(gripper robot ?)"), "(gripper robot 60.0)");
  EXPECT_EQ(refusal("(gripper -1)"), "out-of-range");
}

TEST_F(Robot, TellsWhetherSomethingIsGrippedWhereTheGripperSaysIt) {
  EXPECT_EQ(fact("(gripped robot ?)"), "");
  for (const bool gripped : {false, true}) {
    arm.gripped = gripped;
    executor.run_for(200ms);
    EXPECT_EQ(fact("(gripped robot ?)"), gripped ? "(gripped robot yes)" : "(gripped robot no)");
  }
}

TEST_F(Robot, MonitorAnswersPoseAndJoints) {
  call("(turn right 10)");
  EXPECT_EQ(call("(monitor)"), "(ok 364.38 64.25 410.0 180.0 0.0 10.0 10.0 0.0 -90.0 0.0 -90.0 0.0 2500.0)");
}

TEST_F(Robot, DistancePastTheReachIsClampedAndThenNothingMoves) {
  EXPECT_EQ(call("(extend keep-height 5000)"), "(ok true)");
  const arm::Joints end = arm.at();
  EXPECT_EQ(call("(extend keep-height 1)"), "(ok false)");
  EXPECT_EQ(arm.at(), end);
  EXPECT_EQ(call("(turn right 300)"), "(ok true)");
  EXPECT_NEAR(arm.at()[0], 180, 1e-9);
  EXPECT_EQ(call("(turn right 5)"), "(ok false)");
  EXPECT_EQ(call("(ready)"), "(ok true)");
  EXPECT_EQ(call("(move-v up 5000)"), "(ok true)");
  EXPECT_EQ(call("(move-v up 5)"), "(ok false)");
  EXPECT_EQ(call("(move-h left 9000)"), "(ok true)");
  EXPECT_EQ(call("(move-h left 5)"), "(ok false)");
  EXPECT_EQ(call("(gripper 5000)"), "(ok true)");
  EXPECT_EQ(fact("(gripper robot ?)"), "(gripper robot 100.0)");
}

TEST_F(Robot, RefusedMotionsMoveNothing) {
  const arm::Joints before = arm.at();
  for (const std::string_view bad :
       {"(do-action \"(move 9000 0 100)\")", "(turn sideways 5)", "(turn left -5)", "(retract -5)", "(gripper -1)",
        "(move-v down -5)", "(extend keep-shape 5)", "(goto nowhere)", "(finish tomorrow)", "(turn left ten)",
        "(turn left)", "(turnn left 5)"}) {
    EXPECT_EQ(call(bad).substr(0, 5), "(fail") << bad;
  }
  EXPECT_EQ(arm.moves, 0);
  EXPECT_EQ(arm.at(), before);
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
  EXPECT_EQ(refusal("(turnn left 5)"), "unknown-operation");
  EXPECT_EQ(refusal("(turn sideways 5)"), "wrong-direction");
}

TEST_F(Robot, TellsThePoseTenTimesASecondWhileItMovesAndTheLastBeforeTheReply) {
  call("(speed 5)");
  std::vector<std::string> poses;
  board.set_journal([&](std::string_view line) {
    if (line.find("arm-pose") != std::string_view::npos) poses.emplace_back(line);
  });
  const Time begun = executor.now();
  call("(turn right 24)");
  const double seconds = std::chrono::duration<double>(executor.now() - begun).count();
  EXPECT_GE(poses.size(), static_cast<std::size_t>(seconds * 9));
  EXPECT_LE(poses.size(), static_cast<std::size_t>(seconds * 10) + 2 + 1) << "declarations may be one";
  EXPECT_EQ(first("(arm-joints robot ?)", 2), "(24.0 0.0 -90.0 0.0 -90.0 0.0 2500.0)");
}

TEST_F(Robot, TellsThePoseAsOftenAsItIsToldTo) {
  life.reset();
  life.emplace(executor, board, arm, arm::crs_f3(), RobotOptions{.told_per_s = 125});
  executor.run_for(3s);
  call("(speed 5)");
  std::size_t poses = 0;
  board.set_journal([&](std::string_view line) { poses += line.find("arm-pose") != std::string_view::npos ? 1 : 0; });
  ask("(turn right 24)");
  executor.run_for(1s);
  EXPECT_GE(poses, 120u);
  EXPECT_LE(poses, 127u);
}

TEST_F(Robot, SwingsSlowlyWhatIsBetweenItsFingers) {
  arm.between_fingers_mm = 60;
  EXPECT_EQ(call("(gripper 0)"), "(ok true)");
  EXPECT_EQ(call("(turn right 30)"), "(ok true)");
  EXPECT_LT(arm.last_speed, 0.5);
  EXPECT_EQ(call("(gripper 80)"), "(ok true)");
  EXPECT_EQ(call("(turn left 30)"), "(ok true)");
  EXPECT_EQ(arm.last_speed, 1);
}

}  // namespace
}  // namespace pizarra::robot
