#include "agents/coordinator/geometry/servo.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "blackboard/time/random.hpp"

namespace pizarra::coordinator {
namespace {

using Motion = ServoCommand::Motion;
constexpr double radius_mm = 480;

// An arm that does what it is told, up to a share of the amount and some noise, and a target.
struct Plant {
  double across_mm, along_mm, height_mm, travel_mm;
  double lowest_while_sideways_mm = 1e9;

  ServoErrors errors(Random& random, double noise_mm) const {
    const double across = across_mm + noise_mm * random.normal();
    return {.across_mm = across,
            .bearing_deg = across / radius_mm * 180 / std::numbers::pi,
            .along_mm = along_mm + noise_mm * random.normal(),
            .down_mm = height_mm + noise_mm * random.normal(),
            .clearance_mm = travel_mm - height_mm};
  }

  void perform(const ServoCommand& command, double share) {
    const double amount = command.amount * share;
    switch (command.motion) {
      case Motion::up:
        height_mm += amount;
        break;
      case Motion::down:
        height_mm -= amount;
        break;
      case Motion::turn:
        across_mm -= amount * std::numbers::pi / 180 * radius_mm;
        break;
      case Motion::move_h:
        across_mm -= amount;
        break;
      case Motion::extend:
        along_mm -= amount;
        break;
      case Motion::done:
        break;
    }
    const bool sideways = command.motion == Motion::turn || command.motion == Motion::extend;
    if (sideways && std::abs(amount) > ServoLimits::follow_mm) {
      lowest_while_sideways_mm = std::min(lowest_while_sideways_mm, height_mm);
    }
  }
};

TEST(Servo, GoesUpFirstWhenItIsLowAndFarOff) {
  EXPECT_EQ(servo_command({50, 6, 0, 40, 200}, true), (ServoCommand{0, Motion::up, 200}));
}

TEST(Servo, AlignsAcrossBeforeAlong) {
  EXPECT_EQ(servo_command({50, 6, 30, 270, 0}, true), (ServoCommand{1, Motion::turn, 6}));
  EXPECT_EQ(servo_command({1, 0.1, -30, 270, 0}, true), (ServoCommand{2, Motion::extend, -30}));
}

TEST(Servo, HasStalledWhereTheWayOfTheLastMotionIsStillToGo) {
  const ServoCommand draw_in{2, Motion::extend, -60};
  EXPECT_TRUE(has_stalled({2, Motion::extend, -58}, draw_in));
  EXPECT_FALSE(has_stalled({2, Motion::extend, -20}, draw_in));
  EXPECT_FALSE(has_stalled({2, Motion::extend, 60}, draw_in)) << "it is another way";
  EXPECT_FALSE(has_stalled({1, Motion::turn, -60}, draw_in)) << "it is another motion";
  EXPECT_FALSE(has_stalled({3, Motion::down, 90}, {3, Motion::down, 90})) << "it goes down a step at a time";
}

TEST(Servo, ApproachesInStepsThatAreBounded) {
  const ServoCommand command = servo_command({1, 0.1, 1, 270, 0}, true);
  EXPECT_EQ(command.state, 3);
  EXPECT_EQ(command.motion, Motion::down);
  EXPECT_LE(command.amount, ServoLimits::step_mm);
}

TEST(Servo, ChoosesTurnForCoarseAndMoveHForFineErrorsInStateFour) {
  const ServoCommand coarse = servo_command({ServoLimits::turn_mm + 2, 1, 0, 20, 250}, true);
  EXPECT_EQ(coarse.state, 4);
  EXPECT_EQ(coarse.motion, Motion::turn);
  const ServoCommand fine = servo_command({ServoLimits::turn_mm - 1, 1, 0, 20, 250}, true);
  EXPECT_EQ(fine.state, 4);
  EXPECT_EQ(fine.motion, Motion::move_h);
  EXPECT_LT(std::abs(fine.amount), ServoLimits::turn_mm - 1);
}

TEST(Servo, StaysUpWhenItOnlyAligns) {
  const ServoCommand command = servo_command({1, 0.1, 1, 270, 0}, false);
  EXPECT_EQ(command.motion, Motion::done);
}

TEST(Servo, ComesToTheTargetFromAnywhereAndMovesFarSidewaysOnlyUpHigh) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Plant plant{random.uniform(-300, 300), random.uniform(-100, 100), random.uniform(0, 300), 300};
    const double share = random.uniform(0.85, 1.1);
    int looks = 0;
    ServoCommand command{0, Motion::up, 0};
    while (command.motion != Motion::done && ++looks < 60) {
      command = servo_command(plant.errors(random, 0.1), true);
      plant.perform(command, share);
    }
    EXPECT_LT(looks, 60);
    EXPECT_LT(std::abs(plant.across_mm), 1.5);
    EXPECT_LT(std::abs(plant.along_mm), 1.5);
    EXPECT_LT(std::abs(plant.height_mm), 2.2);
    EXPECT_GT(plant.lowest_while_sideways_mm, plant.travel_mm - 20);
  }
}

TEST(Servo, FollowsATargetThatIsMovedDuringTheApproach) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Plant plant{80, 20, 280, 300};
    int looks = 0;
    bool moved = false;
    bool went_up = false;
    ServoCommand command{0, Motion::up, 0};
    while (command.motion != Motion::done && ++looks < 80) {
      command = servo_command(plant.errors(random, 0.1), true);
      plant.perform(command, 1);
      went_up = went_up || (moved && command.state == 0);
      if (command.state == 3 && !moved) {
        moved = true;
        plant.across_mm += random.uniform(20, 60);
      }
    }
    EXPECT_TRUE(moved);
    EXPECT_TRUE(went_up);
    EXPECT_LT(std::abs(plant.across_mm), 1.5);
    EXPECT_LT(std::abs(plant.height_mm), 2.2);
  }
}

}  // namespace
}  // namespace pizarra::coordinator
