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
  InstantGripper gripper;
  GrippingArm both{arm, gripper};
};

TEST_F(Gripping, AnArmWithoutAGripperGripsAndMovesAsOne) {
  ASSERT_TRUE(ask(both.identify()));
  ASSERT_EQ(outcome(both.take_control()), "");
  EXPECT_TRUE(gripper.ready);
  EXPECT_EQ(outcome(arm.start_gripper(40)), "refused");
  EXPECT_EQ(outcome(both.start_gripper(40)), "");
  EXPECT_EQ(ask(both.read())->opening_mm, 40);
  EXPECT_EQ(ask(both.read())->gripped, false);
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

TEST_F(Gripping, AStandingGripperIsAskedSeldomAndOneThatFailsAtOnceAgain) {
  ASSERT_EQ(connect(), "");
  for (int i = 0; i < 100; ++i) ASSERT_TRUE(ask(both.read()));
  EXPECT_LE(gripper.asked, 10);
  gripper.wrong = Failure{"disconnected", "the gripper does not answer", {}, {}};
  EXPECT_EQ(outcome(both.start_gripper(40)), "disconnected");
  int failed = 0;
  for (int i = 0; i < 30; ++i) failed += ask(both.read()) ? 0 : 1;
  EXPECT_GE(failed, 19) << "what it holds is not known";
  gripper.wrong.reset();
  EXPECT_TRUE(ask(both.read()));
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
  EXPECT_FALSE(ask(arm::meet_arm(executor, both, model())));
  executor.run_for(1s);
  EXPECT_FALSE(read()->moving);
}

}  // namespace
}  // namespace pizarra::gripper
