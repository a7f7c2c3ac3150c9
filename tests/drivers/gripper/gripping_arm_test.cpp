#include "drivers/gripper/gripping_arm.hpp"

#include <gtest/gtest.h>

#include "drivers/arm/meeting.hpp"
#include "tests/drivers/arm/driven_cells.hpp"

namespace pizarra::gripper {
namespace {

// Goes at once where it is told, unless there is something wrong with it.
class InstantGripper : public GripperDriver {
 public:
  std::optional<Failure> wrong;
  double opening_mm = 100;
  int asked = 0;
  bool ready = false;
  Executor* slow = nullptr;  // where it takes three seconds for an answer
  Task<Result<void>> connect() override {
    ready = true;
    co_return trouble();
  }
  Task<Result<void>> start(double opening) override {
    opening_mm = opening;
    co_return trouble();
  }
  Task<Result<GripperReading>> read() override {
    ++asked;
    if (slow != nullptr) co_await sleep(*slow, 3s);
    const Result<void> sound = trouble();
    if (!sound) co_return fail(sound);
    GripperReading reading{opening_mm, false, false};
    co_return reading;
  }

 private:
  Result<void> trouble() const { return wrong ? Result<void>(fail(*wrong)) : Result<void>(); }
};

// Over an arm that has no gripper of its own.
class Gripping : public testing::Test, protected arm::DrivenSimple<false> {
 protected:
  // What the arm and its gripper say now.
  Result<arm::ArmReading> read_both() {
    for (int i = 0; i < 12; ++i) {
      static_cast<void>(ask(both.read()));
      executor.run_for(1ms);
    }
    return ask(both.read());
  }
  InstantGripper gripper;
  GrippingArm both{executor, arm, gripper};
};

TEST_F(Gripping, AnArmWithoutAGripperGripsAndMovesAsOne) {
  ASSERT_TRUE(ask(both.identify()));
  ASSERT_EQ(outcome(both.take_control()), "");
  EXPECT_TRUE(gripper.ready);
  EXPECT_EQ(outcome(arm.start_gripper(40)), "refused");
  EXPECT_EQ(outcome(both.start_gripper(40)), "");
  EXPECT_TRUE(ask(both.read())->gripper_moving) << "it has not been asked since";
  EXPECT_EQ(read_both()->opening_mm, 40);
  EXPECT_EQ(read_both()->gripped, false);
  EXPECT_FALSE(read_both()->gripper_moving);
  arm::Joints there = model().ready;
  there[0] += 30;
  EXPECT_EQ(outcome(both.start_move({there}, 1)), "");
  Result<arm::ArmReading> reading = ask(both.read());
  EXPECT_TRUE(reading->moving);
  while (reading && reading->moving) {
    executor.run_for(20ms);
    reading = ask(both.read());
  }
  ASSERT_TRUE(reading);
  EXPECT_TRUE(arm::are_same_place(reading->joints, there, 0.01));
  EXPECT_EQ(reading->opening_mm, 40);
}

TEST_F(Gripping, AStandingGripperIsAskedSeldom) {
  ASSERT_EQ(connect(), "");
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(ask(both.read()));
  EXPECT_LE(gripper.asked, 10);
}

TEST_F(Gripping, OfAGripperThatFailsTheReadingSaysWhyItTellsNothingAndTheArmGoesOn) {
  ASSERT_EQ(connect(), "");
  EXPECT_FALSE(read_both()->gripper_trouble);
  gripper.wrong = Failure{"disconnected", "the gripper does not answer", {}, {}};
  EXPECT_EQ(outcome(both.start_gripper(40)), "disconnected");
  const Result<arm::ArmReading> without = read_both();
  ASSERT_TRUE(without);
  ASSERT_TRUE(without->gripper_trouble);
  EXPECT_EQ(without->gripper_trouble->sentence, "the gripper does not answer");
  EXPECT_EQ(outcome(both.start_move({moved(0, 10)}, 1)), "");
  gripper.wrong.reset();
  EXPECT_FALSE(read_both()->gripper_trouble);
}

TEST_F(Gripping, ASlowGripperKeepsNobodyWaitingForTheArm) {
  ASSERT_EQ(connect(), "");
  gripper.slow = &executor;
  const Time before = executor.now();
  for (int i = 0; i < 30; ++i) ASSERT_TRUE(ask(both.read()));
  EXPECT_EQ(executor.now(), before);
  executor.run_for(4s);
  EXPECT_FALSE(ask(both.read())->gripper_trouble);
}

TEST_F(Gripping, AnArmWhoseGripperIsNotReadyIsInControlAndSaysSo) {
  ASSERT_TRUE(ask(both.identify()));
  gripper.wrong = Failure{"not-in-control", "the gripper is not activated", {}, {}};
  const Result<void> control = ask(both.take_control());
  ASSERT_FALSE(control);
  EXPECT_EQ(control.error().symbol, "not-in-control");
  EXPECT_EQ(control.error().sentence, "the arm can be moved, and its gripper cannot: the gripper is not activated");
  EXPECT_EQ(outcome(both.start_move({moved(0, 10)}, 1)), "");
}

TEST_F(Gripping, AFailingGripperDoesNotKeepTheArmFromStopping) {
  ASSERT_EQ(connect(), "");
  arm::Joints there = model().ready;
  there[0] += 60;
  ASSERT_EQ(outcome(both.start_move({there}, 0.5)), "");
  executor.run_for(200ms);
  gripper.wrong = Failure{"disconnected", "the gripper does not answer", {}, {}};
  EXPECT_EQ(outcome(both.stop()), "");
  EXPECT_TRUE(wait()->stopped);
}

TEST_F(Gripping, AFailingGripperDoesNotKeepAnArmThatMovesForNobodyFromBeingStopped) {
  ASSERT_EQ(connect(), "");
  arm::Joints there = model().ready;
  there[0] += 60;
  ASSERT_EQ(outcome(both.start_move({there}, 0.1)), "");
  executor.run_for(200ms);
  begin_anew();
  gripper.wrong = Failure{"disconnected", "the gripper does not answer", {}, {}};
  const Result<arm::ArmMeeting> met = ask(arm::meet_arm(executor, both, model()));
  ASSERT_TRUE(met);
  EXPECT_TRUE(met->was_stopped);
  executor.run_for(1s);
  EXPECT_FALSE(read()->moving);
}

}  // namespace
}  // namespace pizarra::gripper
