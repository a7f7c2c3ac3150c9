#include <cmath>
#include <limits>

#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

TEST(SimulatedArm, NamesItsType) {
  Bench bench(four_cubes());
  const Result<std::string> type = run(bench.executor, bench.arm.identify());
  ASSERT_TRUE(type);
  EXPECT_EQ(*type, arm::crs_f3().type);
}

TEST(SimulatedArm, ObeysOnlyWhoHasControl) {
  VirtualExecutor executor;
  const WorldConfig config = four_cubes();
  World world(executor, config);
  LocalLink link(world);
  SimulatedArm arm(link);
  EXPECT_EQ(run(executor, arm.start_move({config.arm.home}, 0.5)).error().symbol, "not-in-control");
  EXPECT_EQ(run(executor, arm.start_gripper(10)).error().symbol, "not-in-control");
  EXPECT_TRUE(run(executor, arm.read()));
  EXPECT_TRUE(run(executor, arm.take_control()));
  EXPECT_TRUE(run(executor, arm.start_move({config.arm.home}, 0.5)));
}

// A controller that has an alarm, and notes what it is asked for.
class AlarmedLink : public Link {
 public:
  Task<Result<Message>> call(Datum request, Duration) override {
    asked.emplace_back(request[1].text());
    if (asked.back() == "read") {
      const Datum joints = list(0.0, 1.0);
      const Datum reading = alarm ? list(joints, "no"_sym, "yes"_sym, 20.0, "no"_sym, 1000, list("alarm"_sym, 4107))
                                  : list(joints, "no"_sym, "yes"_sym, 20.0, "no"_sym, 1000);
      co_return Message{reading, {}};
    }
    if (asked.back() == "take-control") alarm = false;
    if (alarm) co_return fail("not-in-control", "the controller has an alarm", to_datum(4107));
    co_return Message{};
  }
  bool alarm = false;
  std::vector<std::string> asked;
};

TEST(SimulatedArm, AnAlarmIsToldAndNoMotionResetsIt) {
  VirtualExecutor executor;
  AlarmedLink link;
  SimulatedArm arm(link);
  ASSERT_TRUE(run(executor, arm.take_control()));
  link.alarm = true;
  link.asked.clear();
  EXPECT_EQ(run(executor, arm.start_gripper(10)).error().symbol, "not-in-control");
  EXPECT_EQ(run(executor, arm.start_move({arm::Joints(2)}, 0.5)).error().subject, to_datum(4107));
  EXPECT_EQ(link.asked, (std::vector<std::string>{"gripper", "move"}));
  const Result<arm::ArmReading> alarmed = run(executor, arm.read());
  ASSERT_TRUE(alarmed && alarmed->trouble);
  EXPECT_EQ(alarmed->trouble->kind, arm::ArmTrouble::Kind::fault);
  EXPECT_EQ(alarmed->trouble->why.subject, to_datum(4107));
  ASSERT_TRUE(run(executor, arm.take_control()));
  EXPECT_FALSE(run(executor, arm.read())->trouble);
  EXPECT_TRUE(run(executor, arm.start_gripper(10)));
}

TEST(SimulatedArm, DoesNotTakeBackByItselfWhatWasReleased) {
  Bench bench(four_cubes());
  ASSERT_TRUE(run(bench.executor, bench.arm.release_control()));
  EXPECT_EQ(run(bench.executor, bench.arm.start_move({bench.config.arm.home}, 0.5)).error().symbol, "not-in-control");
  ASSERT_TRUE(run(bench.executor, bench.arm.take_control()));
  EXPECT_TRUE(run(bench.executor, bench.arm.start_move({bench.config.arm.home}, 0.5)));
}

TEST(SimulatedArm, RefusesBadMoves) {
  Bench bench(four_cubes());
  const auto refused = [&](std::vector<arm::Joints> path, double speed) {
    return run(bench.executor, bench.arm.start_move(std::move(path), speed)).error().symbol;
  };
  arm::Joints beyond = bench.config.arm.ready;
  beyond[1] = 90;
  EXPECT_EQ(refused({beyond}, 0.5), "joint-limit");
  beyond[1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused({beyond}, 0.5), "not-finite");
  EXPECT_EQ(refused({}, 0.5), "bad-request");
  EXPECT_EQ(refused({bench.config.arm.home}, 0), "bad-request");
  EXPECT_FALSE(bench.reading().moving);
  ASSERT_TRUE(run(bench.executor, bench.arm.start_move({bench.config.arm.home}, 0.5)));
  EXPECT_EQ(refused({bench.config.arm.ready}, 0.5), "busy");
}

TEST(SimulatedArm, NoAxisExceedsItsShareOfSpeed) {
  Bench bench(four_cubes());
  arm::Joints far = bench.config.arm.ready;
  far[0] = 120;
  far[4] = -60;
  const double speed = 0.4;
  ASSERT_TRUE(run(bench.executor, bench.arm.start_move({far}, speed)));
  arm::Joints before = bench.reading().joints;
  double fastest = 0;
  while (bench.reading().moving) {
    bench.wait(50ms);
    const arm::Joints now = bench.reading().joints;
    for (std::size_t axis = 0; axis < bench.config.arm.axes.size(); ++axis) {
      const double rate = std::abs(now[axis] - before[axis]) / 0.05;
      EXPECT_LE(rate, bench.config.arm.axes[axis].speed * speed * 1.09) << "axis " << axis + 1;
      if (axis == 0) fastest = std::max(fastest, rate);
    }
    before = now;
  }
  EXPECT_NEAR(fastest, 240 * speed, 240 * speed * 0.1);
  EXPECT_EQ(bench.reading().joints, far);
  EXPECT_FALSE(bench.reading().stopped);
}

TEST(SimulatedArm, StopsWithinAQuarterOfASecond) {
  Bench bench(four_cubes());
  arm::Joints far = bench.config.arm.ready;
  far[0] = 150;
  ASSERT_TRUE(run(bench.executor, bench.arm.start_move({far}, 0.5)));
  bench.wait(500ms);
  ASSERT_TRUE(run(bench.executor, bench.arm.stop()));
  const double braked_from = bench.reading().joints[0];
  bench.wait(300ms);
  const arm::ArmReading after = bench.reading();
  EXPECT_FALSE(after.moving);
  EXPECT_TRUE(after.stopped);
  EXPECT_GT(after.joints[0], braked_from);
  EXPECT_LT(after.joints[0], 150);
  bench.wait(1s);
  EXPECT_EQ(bench.reading().joints, after.joints);
}

TEST(SimulatedArm, TheGripperTakesItsTime) {
  Bench bench(four_cubes());
  ASSERT_TRUE(run(bench.executor, bench.arm.start_gripper(44)));
  EXPECT_TRUE(bench.reading().gripper_moving);
  bench.wait(250ms);
  EXPECT_NEAR(bench.reading().opening_mm, gripper_opening_mm - 20, 1);
  bench.wait(500ms);
  EXPECT_EQ(bench.reading().opening_mm, 44);
  EXPECT_FALSE(bench.reading().gripper_moving);
}

}  // namespace pizarra::simulation
