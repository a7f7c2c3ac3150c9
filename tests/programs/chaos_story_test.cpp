// What a run under faults draws from its seed.

#include <algorithm>
#include <gtest/gtest.h>
#include <set>

#include "agents/launcher/agent_factory.hpp"
#include "programs/chaos/draw_story.hpp"
#include "tests/programs/four_cubes.hpp"

namespace pizarra::chaos {
namespace {

TEST(ChaosStory, DrawsThreeToFiveCubesOfSeveralSizesWithMarksOfTheirOwn) {
  std::set<std::size_t> counts;
  std::set<double> sizes;
  std::set<std::string> marks;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const forms::CellDescription cell = draw_story(programs::four_cubes(), seed, {}).cell;
    EXPECT_TRUE(launcher::world_config(cell, seed)) << "seed " << seed;
    counts.insert(cell.cubes.size());
    sizes.insert(cell.cube_mm);
    std::set<std::string> own;
    for (const forms::CubePlacement& cube : cell.cubes) {
      EXPECT_EQ(cube.edge_mm, cell.cube_mm) << "seed " << seed;
      EXPECT_TRUE(own.insert(cube.mark).second) << "seed " << seed << ", " << cube.mark;
      marks.insert(cube.mark);
    }
  }
  EXPECT_EQ(counts, (std::set<std::size_t>{3, 4, 5}));
  EXPECT_EQ(*sizes.begin(), 48);
  EXPECT_EQ(*sizes.rbegin(), 60);
  EXPECT_EQ(marks.size(), 12U);
}

TEST(ChaosStory, LeavesCubesThatHaveSizesOfTheirOwnAsTheyAre) {
  forms::CellDescription sized = programs::four_cubes();
  sized.cubes[0].edge_mm = 50;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) EXPECT_EQ(draw_story(sized, seed, {}).cell.cube_mm, 60);
}

}  // namespace
}  // namespace pizarra::chaos
