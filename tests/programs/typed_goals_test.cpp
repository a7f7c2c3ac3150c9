// Goals as they are typed: what is wrong with them is said at its place, before anything runs.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

Said run(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }

TEST(TypedGoals, ARefusalSaysEachFactOnce) {
  const Said said = run("demo --png '' --goal '(on circle triangle) (on triangle circle)'");
  EXPECT_TRUE(contains(said, "can never hold together from here")) << said.text;
  EXPECT_FALSE(contains(said, "from here:")) << said.text;
}

TEST(TypedGoals, AnEmptyGoalIsMalformedInTheSameWordsEverywhere) {
  for (const char* words : {"demo --goal ''", "goal ''", "goal ' '"}) {
    const Said said = run(words);
    EXPECT_EQ(said.status, 2) << words;
    EXPECT_EQ(said.text, "pizarra: nothing is typed: a goal is FACT, (and FACT ...) or several FACTs\n") << words;
  }
}

TEST(TypedGoals, ARefusedGoalOfAStoryIsShownWithACaretToo) {
  const std::string folder = scratch_folder() + "refused-story/";
  std::filesystem::create_directory(folder);
  std::ofstream(folder + "cell.scm") << "(cell c (world (cube circle (at 450 0)) (cube cross (at 450 150))) (domain \""
                                     << source_dir() << "/domains/blocks.scm\"))\n";
  std::ofstream(folder + "story.scm") << "(scenario \"neither way\" (cell \"cell.scm\")\n"
                                         "  (goal (on circle cross) (on cross circle)) (expect reached) (within 60))\n";
  const Said said = run("demo --png '' " + folder + "cell.scm");
  EXPECT_EQ(said.status, 3) << said.text;
  EXPECT_TRUE(contains(said, "goal:1:1\n  (on circle cross) (on cross circle)\n  ^\n")) << said.text;
}

TEST(TypedGoals, WithoutAStoryBesideTheCellAGoalIsAskedFor) {
  const std::string file = scratch_folder() + "lone-cell.scm";
  std::ofstream(file) << "(cell c (world (cube circle (at 450 0))) (domain \"" << source_dir()
                      << "/domains/blocks.scm\"))\n";
  const Said said = run("demo " + file);
  EXPECT_EQ(said.status, 2) << said.text;
  EXPECT_TRUE(contains(said, "--goal")) << said.text;
}

TEST(TypedGoals, AMalformedGoalIsToldAtItsPlaceBeforeAnythingRuns) {
  const Said said = run("demo --goal '(on circle'");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "^")) << said.text;
  EXPECT_FALSE(contains(said, "robot is there")) << said.text;
}

TEST(TypedGoals, AnUnknownPredicateIsToldWithTheNearest) {
  const Said said = run("demo --goal '(onn circle triangle)'");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "nearest is on")) << said.text;
}

TEST(TypedGoals, AGoalWithAnUnknownObjectIsRefusedBeforeAnythingRuns) {
  const Said said = run("demo --png unknown/view.png --goal '(on circle traingle)'");
  EXPECT_EQ(said.status, 2);
  EXPECT_TRUE(contains(said, "nearest is triangle")) << said.text;
  EXPECT_TRUE(contains(said, "goal:1:12\n")) << said.text;
  EXPECT_FALSE(contains(said, " s  ")) << "nothing was played: " << said.text;
  EXPECT_FALSE(std::filesystem::exists(scratch_folder() + "unknown")) << "nothing was written";
}

TEST(TypedGoals, AnUnreachableGoalIsRefusedAndNothingMoves) {
  const Said said = run("demo --png '' --goal '(on circle triangle) (on triangle circle)'");
  EXPECT_EQ(said.status, 3);
  EXPECT_FALSE(contains(said, "operation ")) << said.text;
}

TEST(TypedGoals, ARefusedGoalIsShownWithACaretAtTheFirstFactThatCannotHold) {
  const Said both = run("demo --png '' --goal '(on-table cross) (on circle triangle) (on triangle circle)'");
  EXPECT_EQ(both.status, 3) << both.text;
  EXPECT_TRUE(contains(both, "goal:1:18\n  (on-table cross) (on circle triangle) ")) << both.text;
  EXPECT_TRUE(contains(both, "\n                   ^\n")) << both.text;
  const Said alone = run("demo --png '' --goal '(on Circle circle)'");
  EXPECT_EQ(alone.status, 3) << alone.text;
  EXPECT_TRUE(contains(alone, "goal:1:1\n  (on Circle circle)\n  ^\n")) << alone.text;
}

TEST(TypedGoals, ADemoSaysItsGoalOnce) {
  const Said said = run("demo --png '' --goal '(on-table circle)'");
  const std::size_t first = said.text.find(" s  goal ");
  ASSERT_NE(first, std::string::npos) << said.text;
  EXPECT_EQ(said.text.find(" s  goal ", first + 1), std::string::npos) << said.text;
}

TEST(TypedGoals, ARefusalIsToldOnce) {
  const Said said = run("demo --png '' --goal '(on circle triangle) (on triangle circle)'");
  const std::size_t first = said.text.find("no plan");
  EXPECT_NE(first, std::string::npos) << said.text;
  EXPECT_EQ(said.text.find("no plan", first + 1), std::string::npos) << said.text;
}

}  // namespace
}  // namespace pizarra::programs
