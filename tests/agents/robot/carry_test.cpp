#include "agents/robot/carry.hpp"

#include <gtest/gtest.h>
#include <numbers>

#include "agents/robot/motion.hpp"
#include "drivers/arm/arm_file.hpp"
#include "lisp/reader.hpp"

namespace pizarra::robot {
namespace {

double part_of(std::string_view operation) {
  const arm::ArmModel& model = arm::crs_f3();
  const Result<Motion> motion = plan_motion(model, read_one(operation).value(), model.ready, {});
  return carry_speed(model, model.ready, motion.value().waypoints);
}

TEST(Carry, SwingsNoFasterThanWhatSlipsMayFly) {
  const arm::ArmModel& model = arm::crs_f3();
  const double radius_mm = arm::forward(model, model.ready).translation().head<2>().norm();
  const double full_mm_s = radius_mm * model.axes[0].speed * std::numbers::pi / 180;
  ASSERT_GT(full_mm_s, 2 * carry_mm_s);
  EXPECT_NEAR(part_of("(turn right 60)") * full_mm_s, carry_mm_s, 2);
  EXPECT_NEAR(part_of("(turn left 180)") * full_mm_s, carry_mm_s, 2) << "by its arc, however far it turns";
}

TEST(Carry, GoesUpAndTurnsTheWristAtFullSpeed) {
  EXPECT_EQ(part_of("(move-v down 100)"), 1);
  EXPECT_EQ(part_of("(turn-wrist right 90)"), 1);
}

}  // namespace
}  // namespace pizarra::robot
