// The messages of public clients of these units with the answers that they must get, and the manual's examples.

#include <gtest/gtest.h>

#include "blackboard/time/virtual_executor.hpp"
#include "drivers/simulation/controllers/ptu_emulator.hpp"

namespace pizarra::ptu {
namespace {

class PtuClients : public testing::Test {
 protected:
  PtuClients() {
    unit.on_say([this](std::string_view bytes) { said += bytes; });
  }
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

// ROS' flir_ptu writes its three settings at once, discards what comes, and then takes each line that begins with '*'
// for a number alone.
TEST_F(PtuClients, RosInitialisesItAsksItsRangeAndMovesIt) {
  EXPECT_EQ(say("ft ed ci "), "ft *\r\ned *\r\n*\r\n");
  EXPECT_EQ(say("tr "), "* 185.1428\r\n");
  EXPECT_EQ(say("pr "), "* 185.1428\r\n");
  EXPECT_EQ(say("pn "), "* -3090\r\n");
  EXPECT_EQ(say("tx "), "* 604\r\n");
  EXPECT_EQ(say("pl "), "* 57\r\n");
  EXPECT_EQ(say("tu "), "* 5833\r\n");
  EXPECT_EQ(say("pp500 "), "*\r\n");
  EXPECT_EQ(say("ps800 "), "*\r\n");
  say("", 3s);
  EXPECT_EQ(say("pp "), "* 500\r\n");
  EXPECT_EQ(say("ps "), "* 800\r\n");
}

// It waits 30 seconds for a reset, whatever speed it has set.
TEST_F(PtuClients, RosResetsItInTime) {
  say("ft ed ci ps60 pp-2000 ");
  EXPECT_EQ(say(" r ", 30s), "!T!T!P!P*\r\n");
  EXPECT_EQ(say("ps "), "* 60\r\n");
}

// It tells the modes apart by the first letter of the answer, in lower case.
TEST_F(PtuClients, RosSetsAndReadsTheControlMode) {
  say("ft ed ci ");
  EXPECT_EQ(say("c ").substr(0, 3), "* i");
  EXPECT_EQ(say("cv "), "*\r\n");
  EXPECT_EQ(say("c ").substr(0, 3), "* p");
  EXPECT_EQ(say("ps-800 ", 1s), "*\r\n");
  EXPECT_LT(unit.pan_deg(), -20);
  EXPECT_EQ(say("ps "), "* -800\r\n");
}

// A Python client for the E series: everything it asks when it is made, by the places in the answers that it reads.
TEST_F(PtuClients, APythonClientFindsWhatItReadsWhereItReadsIt) {
  EXPECT_EQ(say("LE "), "LE *\r\n");
  EXPECT_EQ(say("E "), "E * Echoing ON\r\n");
  EXPECT_EQ(say("PNU "), "PNU * Minimum Pan position is -3090\r\n");
  EXPECT_EQ(say("TXU "), "TXU * Maximum Tilt position is 604\r\n");
  EXPECT_EQ(say("PU "), "PU * Maximum Pan speed is 5833 positions/sec\r\n");
  EXPECT_EQ(say("C "), "C * Independent speed control mode\r\n");
  EXPECT_EQ(say("B600,-100,900,500 "), "B600,-100,900,500 *\r\n");
  EXPECT_EQ(say("A ", 3s), "A *\r\n");
  EXPECT_EQ(say("PP "), "PP * Current Pan position is 600\r\n");
  EXPECT_EQ(say("TP "), "TP * Current Tilt position is -100\r\n");
  EXPECT_EQ(say("TS "), "TS * Target Tilt speed is 500 positions/sec\r\n");
}

TEST_F(PtuClients, PlacesAndSpeedsAtOnceAreTakenAllOrNone) {
  say("ED ");
  EXPECT_EQ(say("B600,-100,900,9000 "), "! Tilt speed cannot exceed 5833 positions/sec\r\n");
  EXPECT_EQ(say("B600,-1000,900,500 "), "! Minimum allowable Tilt position is -907\r\n");
  for (const char* wrong : {"B ", "B1,2,900 ", "B1,2,900,500,1 ", "B1,2,,500 "}) {
    EXPECT_EQ(say(wrong), "! Illegal argument entered\r\n") << wrong;
  }
  EXPECT_FALSE(unit.moving());
  EXPECT_EQ(say("PS PO "), "* Target Pan speed is 1000 positions/sec\r\n* Target Pan position is 0\r\n");
}

TEST_F(PtuClients, LimitsOfTheUserHoldWhileTheyAreAskedFor) {
  say("ED ");
  EXPECT_EQ(say("PXU1000 PXU4000 "), "*\r\n! Illegal argument entered\r\n");
  EXPECT_EQ(say("PP1001 PP0 "), "*\r\n*\r\n");
  EXPECT_EQ(say("LU PP1001 "), "*\r\n! Maximum allowable Pan position is 1000\r\n");
  EXPECT_EQ(say("L "), "* Limit bounds are ENABLED (user limits enabled)\r\n");
  EXPECT_EQ(say("LE PP1001 "), "*\r\n*\r\n");
}

TEST_F(PtuClients, InPureVelocityModeTheSignSaysWhereToUntilTheLimit) {
  say("ED CV ");
  EXPECT_EQ(say("PS1000 TS-100 ", 500ms), "*\r\n*\r\n");
  EXPECT_GT(unit.pan_deg(), 5);
  EXPECT_LT(unit.tilt_deg(), -1);
  EXPECT_EQ(say("PO "), "* Target Pan position is 3090\r\n");
  EXPECT_EQ(say("PS-1000 ", 1s), "*\r\n");
  EXPECT_EQ(say("PO "), "* Target Pan position is -3090\r\n");
  EXPECT_EQ(say("PS6000 "), "! Pan speed cannot exceed 5833 positions/sec\r\n");
  say("", 20s);
  EXPECT_FALSE(unit.moving());
  EXPECT_NEAR(unit.pan_deg(), -3090 * 185.1428 / 3600, 1e-9);
}

TEST_F(PtuClients, ASpeedBelowTheLowerBoundHaltsTheAxis) {
  say("ED CV PS1000 TS500 ", 500ms);
  EXPECT_EQ(say("PS56 ", 1s), "*\r\n");
  const double stands = unit.pan_deg();
  say("", 200ms);
  EXPECT_EQ(unit.pan_deg(), stands);
  EXPECT_GT(stands, 5);
  EXPECT_EQ(say("PS TS "), "* Target Pan speed is 0 positions/sec\r\n* Target Tilt speed is 500 positions/sec\r\n");
}

TEST_F(PtuClients, ThePureVelocityModeIsNotKeptWithoutPower) {
  say("ED CV DS ");
  unit.power(false);
  unit.power(true);
  executor.run_for(60s);
  EXPECT_EQ(say("C "), "* Independent speed control mode\r\n");
}

TEST_F(PtuClients, SaysWhatItIs) {
  say("ED ");
  EXPECT_TRUE(say("V ").starts_with("* Pan-Tilt Controller v2.14.0"));
  EXPECT_EQ(say("VV "), "* 2.14.0\r\n");
  EXPECT_EQ(say("VM "), "* ptu46-17.5\r\n");
  EXPECT_TRUE(say("VS ").starts_with("* "));
}

}  // namespace
}  // namespace pizarra::ptu
