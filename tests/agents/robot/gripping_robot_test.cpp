// The robot agent over an arm whose gripper has a controller of its own: slow, not ready, or gone.

#include "drivers/gripper/gripping_arm.hpp"
#include "tests/agents/robot/robot_fixture.hpp"

namespace pizarra::robot {
namespace {

class FakeGripper : public gripper::GripperDriver {
 public:
  explicit FakeGripper(Executor& executor) : executor_(executor) {}
  bool activated = true;
  bool activates = true;  // when it is asked to
  Duration answers_after = 1ms;
  double opening_mm = 80;
  Duration opens_in = 0ms;  // how long its fingers take

  Task<Result<void>> connect() override {
    co_await sleep(executor_, answers_after);
    activated = activated || activates;
    co_return ready();
  }
  Task<Result<void>> start(double opening) override {
    co_await sleep(executor_, answers_after);
    const Result<void> sound = ready();
    if (sound) opening_mm = opening;
    began_ = executor_.now();
    co_return sound;
  }
  Task<Result<gripper::GripperReading>> read() override {
    co_await sleep(executor_, answers_after);
    const Result<void> sound = ready();
    if (!sound) co_return fail(sound);
    gripper::GripperReading reading{opening_mm, executor_.now() - began_ < opens_in, false};
    co_return reading;
  }

 private:
  Result<void> ready() const {
    if (activated) return {};
    return fail("not-in-control", "the gripper is not activated");
  }
  Executor& executor_;
  Time began_{};
};

class GrippingRobot : public Robot {
 protected:
  void SetUp() override {}
  void come_up() {
    life.emplace(executor, board, both);
    executor.run_for(2s);
  }
  FakeGripper hand{executor};
  gripper::GrippingArm both{executor, arm, hand};
};

TEST_F(GrippingRobot, ASlowGripperNeitherStopsTheArmNorHidesItsEnd) {
  come_up();
  hand.answers_after = 3s;
  const std::string id = ask("(turn right 90)");
  executor.run_for(50ms);
  EXPECT_TRUE(arm.moving());
  while (arm.moving()) executor.run_for(10ms);
  executor.run_for(100ms);
  EXPECT_EQ(reply(id), "(ok true)");
  EXPECT_EQ(first("(arm robot ?state ?)", 2), "idle");
}

TEST_F(GrippingRobot, ComesUpWithAGripperThatIsNotActivatedAndControlActivatesIt) {
  hand.activated = hand.activates = false;
  come_up();
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
  EXPECT_EQ(fact("(gripper robot ?)"), "") << "what is not known is not told";
  EXPECT_EQ(call("(turn right 10)"), "(ok true)");
  EXPECT_EQ(call("(gripper 40)"),
            "(fail not-in-control \"the gripper is not activated; (get-control) takes it back\" ())");
  EXPECT_EQ(refusal("(get-control)"), "not-in-control");
  EXPECT_EQ(call("(turn left 10)"), "(ok true)");
  hand.activates = true;
  EXPECT_EQ(call("(get-control)"), "(ok true)");
  EXPECT_EQ(call("(gripper 40)"), "(ok true)");
  executor.run_for(2s);
  EXPECT_EQ(fact("(gripper robot ?)"), "(gripper robot 40.0)");
}

TEST_F(GrippingRobot, AGripperThatLostItsPowerIsActivatedByTakingControlAnew) {
  come_up();
  ASSERT_EQ(call("(gripper 40)"), "(ok true)");
  hand.activated = false;
  executor.run_for(3s);
  EXPECT_EQ(fact("(gripper robot ?)"), "");
  EXPECT_EQ(fact("(arm robot fault ?)"), "");
  EXPECT_EQ(call("(turn right 10)"), "(ok true)");
  EXPECT_FALSE(hand.activated) << "nobody asked for it";
  EXPECT_EQ(call("(get-control)"), "(ok true)");
  EXPECT_EQ(call("(gripper 60)"), "(ok true)");
}

// The arm that an operator pushes away is told of, and held, while its gripper keeps everybody waiting.
TEST_F(GrippingRobot, ASlowGripperThatIsToBeginHidesNothingOfTheArm) {
  come_up();
  hand.answers_after = 10s;
  const std::string id = ask("(gripper 40)");
  executor.run_for(100ms);
  arm::Joints pushed = arm.at();
  pushed[0] += 5;
  arm.put(pushed);
  const std::string before = fact("(arm-joints robot ?)");
  executor.run_for(2s);
  EXPECT_NE(fact("(arm-joints robot ?)"), before);
  EXPECT_EQ(reply(id), "");
}

TEST_F(GrippingRobot, IsThereWhileItsGripperIsBeingActivated) {
  hand.activated = false;
  hand.answers_after = 8s;
  come_up();
  EXPECT_EQ(fact("(arm robot ? ?)"), "(arm robot idle \"NO_ACTION\")");
  const std::string id = ask("(turn right 10)");
  executor.run_for(2s);
  EXPECT_EQ(reply(id), "(ok true)");
  EXPECT_EQ(call("(gripper 40)"), "(ok true)") << "it waits for that";
}

TEST_F(GrippingRobot, AGripperThatDiesAsItIsStoppedDoesNotTakeTheArmWithIt) {
  come_up();
  ASSERT_EQ(call("(gripper 80)"), "(ok true)");
  hand.opens_in = 5s;
  const std::string id = ask("(gripper 20)");
  executor.run_for(500ms);
  hand.answers_after = 200ms;
  hand.activated = false;
  Transaction stop;
  stop.tell(form("(stop user \"now\")"));
  ASSERT_TRUE(board.transact("user", stop));
  executor.run_for(50ms);
  for (int i = 0; i < 200; ++i) {
    executor.run_for(20ms);
    ASSERT_EQ(fact("(arm robot fault ?)"), "");
  }
  EXPECT_TRUE(reply(id).starts_with("(fail ")) << reply(id);
}

// A reading that took a while is of when it was taken.
class LateArm : public FakeArm {
 public:
  explicit LateArm(Executor& executor) : FakeArm(executor), clock_(executor) {}
  Task<Result<arm::ArmReading>> read() override {
    const Time at = clock_.now();
    Result<arm::ArmReading> reading = co_await FakeArm::read();
    if (++reads_ % 10 == 0) co_await sleep(clock_, 120ms);
    if (reading) reading->at = at;
    co_return reading;
  }

 private:
  Executor& clock_;
  int reads_ = 0;
};

TEST(LateReadings, AreNotTakenForSpeed) {
  VirtualExecutor executor;
  memory::MemoryBoard board(executor);
  LateArm arm(executor);
  const RobotLife life(executor, board, arm);
  executor.run_for(2s);
  Transaction request;
  request.tell(form("(request turn robot (turn right 150))"));
  ASSERT_TRUE(board.transact("user", request));
  executor.run_for(10s);
  const Answers answers = board.ask(query_from_datum(form("(reply turn ?answer)")).value()).value();
  ASSERT_FALSE(answers.answers.empty());
  EXPECT_EQ(write(answers.answers.front().facts.front().datum[2]), "(ok true)");
}

}  // namespace
}  // namespace pizarra::robot
