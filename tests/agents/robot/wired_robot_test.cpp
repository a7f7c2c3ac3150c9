// The robot agent over controllers on wires, emulated, in virtual time.

#include "tests/agents/robot/robot_fixture.hpp"
#include "tests/drivers/arm/motoman/hses_cell.hpp"

namespace pizarra::robot {
namespace {

class WiredRobot : public testing::Test {
 protected:
  std::string call(std::string_view operation) {
    const std::string id = fmt::format("r{}", ++asked_);
    Transaction request;
    request.tell(list("request"_sym, Datum::symbol(id), "robot"_sym, form(operation)));
    EXPECT_TRUE(board.transact("user", request)) << operation;
    return reply(id);
  }
  std::string reply(const std::string& id) {
    const Query query = query_from_datum(form(fmt::format("(reply {} ?answer)", id))).value();
    const Time deadline = cell.executor.now() + 60s;
    cell.executor.run_until([&] { return !board.ask(query)->answers.empty() || cell.executor.now() > deadline; });
    const Answers answers = board.ask(query).value();
    return answers.answers.empty() ? "" : write(answers.answers.front().facts.front().datum[2]);
  }

  // Its answer is that of the request `turn`.
  void begin_turn() {
    Transaction request;
    request.tell(form("(request turn robot (turn right 90))"));
    ASSERT_TRUE(board.transact("user", request));
    cell.executor.run_for(500ms);
  }

  arm::HsesCell cell;
  memory::MemoryBoard board{cell.executor};
  int asked_ = 0;
};

TEST_F(WiredRobot, DoesItsOperationsOverALineThatLosesAFifth) {
  cell.line.loss = 0.2;
  cell.line.duplication = 0.1;
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(2s);
  for (const std::string_view operation :
       {"(gripper 84)", "(extend keep-height 80)", "(move-v down 100)", "(move-h left 120)", "(turn right 20)",
        "(turn-wrist left 10)", "(turn-ef up 10)", "(turn-ef down 10)", "(retract 60)", "(gripper 40)", "(ready)"}) {
    EXPECT_EQ(call(operation), "(ok true)") << operation;
  }
  EXPECT_TRUE(arm::are_same_place(cell.read()->joints, arm::up6().ready));
}

TEST_F(WiredRobot, AFaultSaysWhichDeviceIsAwayAndWhy) {
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(1s);
  begin_turn();
  cell.line.pulled = true;
  EXPECT_EQ(form(reply("turn"))[1].text(), "disconnected");
  cell.executor.run_for(1s);
  const Answers told = board.ask(query_from_datum(form("(arm robot fault ?)")).value()).value();
  ASSERT_EQ(told.answers.size(), 1U);
  const std::string why(told.answers.front().facts.front().datum[3].text());
  EXPECT_TRUE(why.starts_with("the arm cannot be commanded: ")) << why;
  EXPECT_NE(why.find("the end of a lossy line"), std::string::npos) << why;
}

TEST_F(WiredRobot, SaysWhyTheControllerEndedAMotionAndGoesOnWhenAskedAnew) {
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(1s);
  begin_turn();
  ASSERT_TRUE(cell.cabinet.obey("alarm 4321"));
  EXPECT_EQ(reply("turn"), R"((fail stopped "the controller has alarm 4321" 4321))");
  cell.executor.run_for(5s);
  EXPECT_EQ(cell.cabinet.alarm(), 4321) << "nobody asked for its reset";
  EXPECT_EQ(call("(turn left 5)"),
            R"((fail not-in-control "the controller has alarm 4321; (get-control) takes it back" 4321))");
  EXPECT_EQ(call("(get-control)"), "(ok true)");
  EXPECT_EQ(call("(ready)"), "(ok true)");
}

TEST_F(WiredRobot, LeavesAlarmAndServosAsTheyAreWhenTheControllerIsBack) {
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(1s);
  begin_turn();
  ASSERT_TRUE(cell.cabinet.obey("power off"));
  cell.executor.run_for(4s);
  ASSERT_TRUE(cell.cabinet.obey("power on"));
  cell.executor.run_for(10s);
  EXPECT_EQ(cell.cabinet.alarm(), simulation::ArmCabinet::power_lost_alarm);
  EXPECT_FALSE(cell.cabinet.servo());
  EXPECT_TRUE(call("(monitor)").starts_with("(ok ")) << "monitoring goes on";
  EXPECT_TRUE(call("(ready)").starts_with("(fail not-in-control"));
  EXPECT_EQ(call("(get-control)"), "(ok true)");
  EXPECT_TRUE(cell.cabinet.servo());
  EXPECT_EQ(call("(ready)"), "(ok true)");
}

TEST_F(WiredRobot, AnAlarmAtTheAgentsStartIsNotResetByIt) {
  ASSERT_TRUE(cell.cabinet.obey("alarm 77"));
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(10s);
  EXPECT_EQ(cell.cabinet.alarm(), 77);
  EXPECT_FALSE(cell.cabinet.servo());
  EXPECT_EQ(call("(get-control)"), "(ok true)");
  EXPECT_EQ(call("(ready)"), "(ok true)");
}

TEST_F(WiredRobot, FingersAreRefusedUnderTheEmergencyStopAndUnderAnAlarm) {
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(1s);
  ASSERT_EQ(call("(gripper 80)"), "(ok true)");
  for (const std::string_view trouble : {"estop on", "alarm 77"}) {
    ASSERT_TRUE(cell.cabinet.obey(trouble));
    cell.executor.run_for(1s);
    EXPECT_TRUE(call("(gripper 20)").starts_with("(fail not-in-control")) << trouble;
    EXPECT_NEAR(cell.read()->opening_mm, 80, 0.1) << trouble;
    ASSERT_TRUE(cell.cabinet.obey("estop off"));
  }
}

TEST_F(WiredRobot, SaysAtRestWhyTheControllerWouldNotMove) {
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(1s);
  const auto arm = [&] {
    cell.executor.run_for(500ms);
    return write(board.ask(query_from_datum(form("(arm robot ?state ?why)")).value())->answers[0].facts[0].datum);
  };
  EXPECT_EQ(arm(), R"((arm robot idle "NO_ACTION"))");
  ASSERT_TRUE(cell.cabinet.obey("pendant on"));
  EXPECT_EQ(arm(), R"((arm robot stopped "the pendant has control"))");
  ASSERT_TRUE(cell.cabinet.obey("pendant off"));
  EXPECT_EQ(arm(), R"((arm robot idle "NO_ACTION"))");
  ASSERT_TRUE(cell.cabinet.obey("estop on"));
  EXPECT_EQ(
      arm(),
      R"((arm robot stopped "the controller's servos are off, as by its emergency stop, which it does not tell apart"))");
  ASSERT_TRUE(cell.cabinet.obey("alarm 77"));
  EXPECT_EQ(arm(), R"((arm robot fault "the controller has alarm 77"))");
}

TEST_F(WiredRobot, AStopFactBrakesTheController) {
  const RobotLife life(cell.executor, board, cell.arm, arm::up6());
  cell.executor.run_for(1s);
  Transaction request;
  request.tell(form("(request turn robot (turn right 120))"));
  ASSERT_TRUE(board.transact("user", request));
  cell.executor.run_for(500ms);
  Transaction stop;
  stop.tell(form("(stop somebody \"a child\")"));
  ASSERT_TRUE(board.transact("somebody", stop));
  cell.executor.run_for(20ms);
  EXPECT_TRUE(cell.cabinet.command_hold());
  EXPECT_TRUE(reply("turn").starts_with("(fail stopped")) << reply("turn");
}

}  // namespace
}  // namespace pizarra::robot
