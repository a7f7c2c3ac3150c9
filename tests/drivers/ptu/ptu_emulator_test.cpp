#include "drivers/simulation/controllers/ptu_emulator.hpp"

#include <cmath>
#include <gtest/gtest.h>

#include "blackboard/time/virtual_executor.hpp"

namespace pizarra::ptu {
namespace {

class Ptu : public testing::Test {
 protected:
  Ptu() {
    unit.on_say([this](std::string_view bytes) { said += bytes; });
    say("ED ");
  }
  // What the unit says to it within `time`.
  std::string say(std::string_view bytes, Duration time = 100ms) {
    said.clear();
    unit.receive(bytes);
    executor.run_for(time);
    return said;
  }

  VirtualExecutor executor;
  std::string said;
  simulation::PtuEmulator unit{executor, *simulation::find_ptu_model("ptu46-17.5")};
};

TEST_F(Ptu, TellsItsResolutionAndLimitsInTheManualsWords) {
  EXPECT_EQ(say("PR "), "* 185.1428 seconds arc per position\r\n");
  EXPECT_EQ(say("PN "), "* Minimum Pan position is -3090\r\n");
  EXPECT_EQ(say("tx\r"), "* Maximum Tilt position is 604\r\n");
  EXPECT_EQ(say("FT PP "), "*\r\n* 0\r\n");
}

TEST_F(Ptu, RefusesWhatLiesBeyondItsLimitsAndStaysWhereItIs) {
  EXPECT_EQ(say("PP3091 "), "! Maximum allowable Pan position is 3090\r\n");
  EXPECT_EQ(say("TP-908 "), "! Minimum allowable Tilt position is -907\r\n");
  EXPECT_EQ(say("PS5834 "), "! Pan speed cannot exceed 5833 positions/sec\r\n");
  EXPECT_EQ(say("PP12x "), "! Illegal argument entered\r\n");
  EXPECT_EQ(say("PP99999999999999 "), "! Illegal argument entered\r\n");
  EXPECT_EQ(say("QQ "), "! Illegal command entered\r\n");
  EXPECT_EQ(say("PP TP "), "* Current Pan position is 0\r\n* Current Tilt position is 0\r\n");
}

TEST_F(Ptu, MovesInTimeAndAwaitAnswersWhenItStands) {
  EXPECT_EQ(say("PP1000 "), "*\r\n");
  EXPECT_GT(unit.pan_deg(), 0.1);
  EXPECT_LT(unit.pan_deg(), 5);
  EXPECT_EQ(say("A "), "");
  EXPECT_EQ(say("", 3s), "*\r\n");
  EXPECT_NEAR(unit.pan_deg(), 1000 * 185.1428 / 3600, 1e-9);
  EXPECT_FALSE(unit.moving());
}

TEST_F(Ptu, TakesAsLongAsItsSpeedAndAccelerationSay) {
  // A ramp from 57 to 1000 counts/s at 2000 counts/s^2 and back, and the rest at 1000 counts/s.
  const double ramp_s = (1000.0 - 57) / 2000;
  const double ramp_counts = (1000.0 * 1000 - 57.0 * 57) / (2 * 2000);
  const double expected_s = 2 * ramp_s + (3000 - 2 * ramp_counts) / 1000;
  unit.receive("PP3000 ");
  const Time begun = executor.now();
  executor.run_for(1ms);
  while (unit.moving()) executor.run_for(1ms);
  EXPECT_NEAR(std::chrono::duration<double>(executor.now() - begun).count(), expected_s, 0.01);
}

TEST_F(Ptu, InSlavedModeBothAxesBeginWhenAwaited) {
  EXPECT_EQ(say("S PP500 TP-200 ", 1s), "*\r\n*\r\n*\r\n");
  EXPECT_FALSE(unit.moving());
  say("A ", 3s);
  EXPECT_EQ(said, "*\r\n");
  EXPECT_EQ(say("PP TP "), "* Current Pan position is 500\r\n* Current Tilt position is -200\r\n");
}

TEST_F(Ptu, HaltSlowsDownAndStandsShortOfTheTarget) {
  say("PP3000 ", 1s);
  EXPECT_EQ(say("H ", 1s), "*\r\n");
  EXPECT_FALSE(unit.moving());
  EXPECT_GT(unit.pan_deg(), 30);
  EXPECT_LT(unit.pan_deg(), 80);
}

TEST_F(Ptu, ATargetChangedOnTheWayIsGoneToWithoutAJump) {
  say("PP3000 ", 1s);
  unit.receive("PP-3000 ");
  double at = unit.pan_deg();
  double moved = 0;
  for (int i = 0; i < 1000; ++i) {
    executor.run_for(10ms);
    const double now = unit.pan_deg();
    moved = std::max(moved, std::abs(now - at));
    at = now;
  }
  EXPECT_LT(moved, 1000 * 185.1428 / 3600 * 0.0101);
  EXPECT_EQ(say("PP "), "* Current Pan position is -3000\r\n");
}

TEST_F(Ptu, ResetsAgainstBothStopsTiltFirst) {
  say("PP1000 TP100 ", 3s);
  EXPECT_EQ(say("R ", 60s), "!T!T!P!P*\r\n");
  EXPECT_EQ(say("PP TP "), "* Current Pan position is 0\r\n* Current Tilt position is 0\r\n");
}

TEST_F(Ptu, EchoesEachCommandBeforeItsAnswerWhereAsked) {
  say("EE ");
  EXPECT_EQ(say("PP100 "), "PP100 *\r\n");
  EXPECT_EQ(say("R ", 60s), "R !T!T!P!P*\r\n");
}

TEST_F(Ptu, BeyondALimitThatIsOffItRunsAgainstTheStopAndSaysSo) {
  EXPECT_EQ(say("LD "), "*\r\n");
  EXPECT_EQ(say("PP4000 ", 20s), "*\r\n!P");
  EXPECT_NEAR(unit.pan_deg(), 3090 * 185.1428 / 3600, 1e-9);
}

TEST_F(Ptu, WithoutPowerItStandsSaysNothingAndForgetsWhereItIs) {
  say("PP3000 ", 1s);
  unit.power(false);
  const double at = unit.pan_deg();
  EXPECT_GT(at, 30);
  EXPECT_EQ(say("PP ", 2s), "");
  EXPECT_EQ(unit.pan_deg(), at);
  said.clear();
  unit.power(true);
  executor.run_for(60s);
  EXPECT_EQ(said, "!T!T!P!P*\r\n");
  EXPECT_NEAR(unit.pan_deg(), 0, 1e-9);
}

TEST_F(Ptu, WithoutAResetAtPowerUpItCountsFromWhereItStands) {
  say("PP1000 RD DS ", 3s);
  unit.power(false);
  unit.power(true);
  executor.run_for(1s);
  EXPECT_EQ(say("PP "), "* Current Pan position is 0\r\n");
  EXPECT_NEAR(unit.pan_deg(), 1000 * 185.1428 / 3600, 1e-9);
}

TEST_F(Ptu, EndlessBytesWithoutADelimiterAreBounded) {
  const std::string noise(1000, 'P');
  for (int i = 0; i < 100; ++i) unit.receive(noise);
  EXPECT_TRUE(say(" ").starts_with("! Illegal"));
  EXPECT_EQ(say("PP "), "* Current Pan position is 0\r\n");
}

}  // namespace
}  // namespace pizarra::ptu
