#include <gtest/gtest.h>

#include "lisp/forms/scenario_file.hpp"
#include "tests/source_dir.hpp"

namespace pizarra {
namespace {

Result<forms::Scenario> story_of_two_cubes(const std::string& cell) {
  const std::string text = "(scenario \"s\" (cell \"" + cell +
                           "\") (goal (on circle square))\n"
                           "  (cubes (cube circle (at 450 0)) (cube square (at 450 55))))";
  return forms::read_scenario(text, source_dir() + "/tests/scenarios/story.scm");
}

TEST(Scenario, GivesItsCubesTheRoomThatTheCellsNeed) {
  const Result<forms::Scenario> small = story_of_two_cubes("cells/small-cubes.scm");
  EXPECT_TRUE(small) << describe(small.error());
  const Result<forms::Scenario> large = story_of_two_cubes("../../examples/01-blocks/cell.scm");
  ASSERT_FALSE(large);
  EXPECT_EQ(large.error().symbol, "overlap");
  EXPECT_NE(large.error().place.find("story.scm:2:35"), std::string::npos) << large.error().place;
}

TEST(Scenario, LeavesACellThatIsNotThereToWhoOpensIt) { EXPECT_TRUE(story_of_two_cubes("nowhere.scm")); }

}  // namespace
}  // namespace pizarra
