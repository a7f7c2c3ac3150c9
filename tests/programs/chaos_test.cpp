// Runs in which everything fails, at the shell: what they say of themselves.

#include <gtest/gtest.h>

#include "tests/programs/shell.hpp"

namespace pizarra::programs {
namespace {

Said run(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " chaos " + words + " 2>&1"); }

// How fast it went differs from time to time.
std::string without_speed(const std::string& text) { return text.substr(0, text.rfind("\nseed")); }

TEST(Chaos, TheSameSeedIsTheSameRun) {
  const Said once = run("--replay 3");
  const Said again = run("--replay 3");
  EXPECT_TRUE(contains(once, "goal 1")) << once.text;
  EXPECT_TRUE(contains(once, " fault ")) << once.text;
  EXPECT_EQ(without_speed(once.text), without_speed(again.text));
}

TEST(Chaos, WithoutFaultsTheGoalIsReached) {
  const Said said = run("--replay 1 --faults none");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, "reached")) << said.text;
}

// They say nothing of the goal, which stays wanted until they are over.
TEST(Chaos, AStopThePendantAndAFullDiskHoldTheCellUpAndTheGoalIsReached) {
  for (const char* kind : {"stop", "pendant", "disk"}) {
    const Said said = run("--runs 2 --first-seed 1 --no-shrink --only " + std::string(kind));
    EXPECT_EQ(said.status, 0) << said.text;
  }
}

TEST(Chaos, TheLastLineCountsTheRuns) {
  const Said said = run("--runs 2 --first-seed 3 --only slip");
  const std::string last = said.text.substr(said.text.rfind("chaos runs"));
  EXPECT_TRUE(last.starts_with("chaos runs 2 reached ")) << said.text;
  EXPECT_NE(last.find(" unreached "), std::string::npos) << said.text;
}

TEST(Chaos, AClassThatIsNotThereIsToldWithThoseThatAre) {
  const Said said = run("--only frogs");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "there is no class of faults frogs; there are network, ")) << said.text;
}

}  // namespace
}  // namespace pizarra::programs
