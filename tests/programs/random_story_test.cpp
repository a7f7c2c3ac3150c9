#include "programs/story/random_story.hpp"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "agents/launcher/agent_factory.hpp"
#include "lisp/writer.hpp"
#include "programs/story/scenario_run.hpp"
#include "tests/programs/four_cubes.hpp"

namespace pizarra::programs {
namespace {

std::string text_of(const story::RandomStory& story) {
  std::string out = write(Datum::list(story.scenario.goal)) + write(Datum::list(story.scenario.events[0].actions));
  for (const forms::CubePlacement& cube : story.cell.cubes) {
    out += cube.name + " " + std::to_string(cube.x_mm) + " " + std::to_string(cube.y_mm) + " " + cube.on + ";";
  }
  return out;
}

TEST(RandomStory, TheSameSeedGivesTheSameStoryAndAnotherSeedAnother) {
  std::set<std::string> stories;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const std::string text = text_of(story::random_story(four_cubes(), Random(seed)));
    EXPECT_EQ(text, text_of(story::random_story(four_cubes(), Random(seed)))) << "seed " << seed;
    stories.insert(text);
  }
  EXPECT_EQ(stories.size(), 50U);
}

TEST(RandomStory, EveryStoryCanBePlayedInASoundWorld) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const story::RandomStory story = story::random_story(four_cubes(), Random(seed));
    EXPECT_TRUE(launcher::world_config(story.cell, seed)) << "seed " << seed;
    EXPECT_TRUE(story::check_scenario(story.scenario)) << "seed " << seed;
    EXPECT_FALSE(story.scenario.goal.empty()) << "seed " << seed;
    EXPECT_EQ(story.cell.cubes.size(), 4U) << "seed " << seed;
  }
}

TEST(RandomStory, MoreCubesThanTheRowHasRoomForStandInPilesThatLeaveAPlaceFree) {
  forms::CellDescription cell = four_cubes();
  for (const char* name : {"star", "house", "arrow", "letter-h"}) cell.cubes.push_back({name, name, 450, 0, 0, ""});
  const auto room = static_cast<std::ptrdiff_t>((cell.row.y_high_mm - cell.row.y_low_mm) / cell.openings.wide_mm);
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const story::RandomStory story = story::random_story(cell, Random(seed));
    EXPECT_TRUE(launcher::world_config(story.cell, seed)) << "seed " << seed;
    EXPECT_EQ(story.cell.cubes.size(), 8U) << "seed " << seed;
    const auto piles = std::ranges::count(story.cell.cubes, std::string(), &forms::CubePlacement::on);
    EXPECT_LT(piles, room) << "seed " << seed;
  }
}

// The arm travels at 300 mm.
TEST(RandomStory, NoPileIsHigherThanTheArmPassesOver) {
  forms::CellDescription cell = four_cubes();
  for (const char* name : {"star", "house", "arrow", "letter-h"}) cell.cubes.push_back({name, name, 450, 0, 0, ""});
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    const story::RandomStory story = story::random_story(cell, Random(seed));
    std::size_t highest = 0;
    std::size_t high = 0;
    for (const forms::CubePlacement& cube : story.cell.cubes) {
      high = cube.on.empty() ? 1 : high + 1;
      highest = std::max(highest, high);
    }
    EXPECT_LE(highest, 5U) << "seed " << seed;
  }
}

}  // namespace
}  // namespace pizarra::programs
