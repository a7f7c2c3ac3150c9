// Runs in which everything fails, at the shell: what they say of themselves.

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

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
TEST(Chaos, AStopThePendantAnAlarmAndAFullDiskHoldTheCellUpAndTheGoalIsReached) {
  for (const char* kind : {"stop", "pendant", "alarm", "disk"}) {
    const Said said = run("--runs 2 --first-seed 1 --no-shrink --only " + std::string(kind));
    EXPECT_EQ(said.status, 0) << said.text;
  }
}

TEST(Chaos, ObserversFindEyesThatNeverSeeACubeAndAnArmThatHeedsNoStop) {
  const Said unseen = run("--plant one-unseen --runs 6");
  EXPECT_TRUE(contains(unseen, "found by run")) << unseen.text;
  const Said swallowed = run("--plant stop-swallowed --only stop --runs 6");
  EXPECT_TRUE(contains(swallowed, "found by run")) << swallowed.text;
}

// Each by the run in which it is found.
TEST(Chaos, ObserversSayWhatAPlantedFaultDoes) {
  const std::pair<const char*, const char*> planted[] = {
      {"--replay 1 --only stop --plant commander-unheard", "a motion begins for coordinator under (commander"},
      {"--replay 6 --only stop --plant fingers-not-held", "the fingers move on after a stop came to the arm"},
      {"--replay 4 --only stop --plant stop-heeded-late", "the arm moves on after a stop came to its controller"},
      {"--replay 29 --only arm --plant silence-ignored", "the arm moves on though its controller has heard nothing"},
      {"--replay 1 --faults none --plant motion-repeated", "a motion is made again for the request"},
      {"--replay 7 --only stop --plant commander-heard-at-rest", "the arm moves on for coordinator under (commander"},
      {"--replay 1 --faults none --plant plan-not-kept", "the board does not keep the plan"},
      {"--replay 1 --faults none --plant goal-not-kept", "the board does not keep goal 1"},
      {"--replay 1 --only slip --plant places-kept", "mm from where it is in plain sight"},
      {"--replay 1 --only slip --plant beliefs-kept", "is believed, and the world does not show it"}};
  for (const auto& [words, sentence] : planted) {
    const Said said = run(words);
    EXPECT_TRUE(contains(said, sentence)) << words << '\n' << said.text;
  }
}

// In this run while a block is carried: (nudge 1.07 -1.46).
TEST(Chaos, AHeadThatIsTurnedByHandIsFoundOutAndTheGoalIsReached) {
  const Said said = run(source_dir() + "/examples/03-moving-head/cell.scm --replay 4 --only bump");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(contains(said, " fault       (bump (servo 2 STACK 1.2) (nudge ")) << said.text;
  EXPECT_TRUE(contains(said, "the camera was moved")) << said.text;
}

// In this run its power is cut as the last goal ends.
TEST(Chaos, ABoardThatIsAwayAtTheEndIsAskedForWhatItKeepsWhenItIsBack) {
  const Said said = run("--replay 6200084");
  EXPECT_TRUE(contains(said, "(power-cut 76 1.67)")) << said.text;
  EXPECT_FALSE(contains(said, "UNSAFE")) << said.text;
}

TEST(Chaos, ClassesStandWithCommasOrBlanksBetween) {
  for (const char* classes : {"stop,slip", "stop slip"}) {
    const Said said = run(fmt::format("--seeds 1 --first-seed 3 --only {}", classes));
    EXPECT_EQ(said.status, 0) << said.text;
    EXPECT_TRUE(contains(said, "chaos runs 1 ")) << said.text;
  }
}

TEST(Chaos, TheLastLineCountsTheRuns) {
  const Said said = run("--runs 2 --first-seed 3 --only slip");
  const std::string last = said.text.substr(said.text.rfind("chaos runs"));
  EXPECT_TRUE(last.starts_with("chaos runs 2 reached ")) << said.text;
  EXPECT_NE(last.find(" unreached "), std::string::npos) << said.text;
}

TEST(Chaos, APointThatTheReferenceHasOftenIsNotLostUnnoticed) {
  const std::string file = scratch_folder() + "coverage.txt";
  const std::string runs = "--runs 1 --first-seed 3 --only slip --no-shrink ";
  run(runs + "--coverage " + file);
  const Said alike = run(runs + "--reference " + file);
  EXPECT_EQ(alike.status, 0) << alike.text;
  std::ofstream(file, std::ios::app) << "event seldom 4\nevent often 5\n";
  const Said lost = run(runs + "--reference " + file);
  EXPECT_EQ(lost.status, 1) << lost.text;
  EXPECT_TRUE(contains(lost, "\nlost: event often\n")) << lost.text;
  EXPECT_FALSE(contains(lost, "seldom")) << lost.text;
}

TEST(Chaos, AReferenceOfOtherRunsIsRefusedBeforeTheFirst) {
  const std::string file = scratch_folder() + "others.txt";
  std::ofstream(file) << "runs 7\nfirst-seed 2\nfailed 0\nunsafe 0\nhung 0\n";
  const Said said = run("--runs 8 --first-seed 2 --reference " + file);
  EXPECT_EQ(said.status, 2) << said.text;
  EXPECT_TRUE(contains(said, "is of 7 runs from seed 2: give --runs 7 --first-seed 2")) << said.text;
  EXPECT_FALSE(contains(said, "reached")) << said.text;
}

TEST(Chaos, AClassThatIsNotThereIsToldWithThoseThatAre) {
  const Said said = run("--only frogs");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "there is no class of faults frogs; there are network, ")) << said.text;
}

}  // namespace
}  // namespace pizarra::programs
