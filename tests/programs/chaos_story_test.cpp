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

// Each kind by its first word.
TEST(ChaosStory, DrawsEachKindOfFaultThatAClassHas) {
  const std::pair<const char*, std::set<std::string>> classes[] = {
      {"frames", {"dropped", "frozen", "late", "doubled"}},
      {"arm", {"away", "acks-late", "acks-twice", "stops-short"}},
      {"sight", {"hidden", "jumps", "invented"}},
      {"board", {"kill", "power-cut"}},
      {"clock", {"jump"}}};
  for (const auto& [kind, words] : classes) {
    std::set<std::string> drawn;
    for (std::uint64_t seed = 1; seed <= 100; ++seed) {
      for (const Fault& fault : draw_story(programs::four_cubes(), seed, {kind}).faults)
        drawn.emplace(fault.what.head());
    }
    EXPECT_EQ(drawn, words) << kind;
  }
}

// (pause WHO K S), (kill WHO K S), (kill K S), (power-cut K S)
TEST(ChaosStory, DrawsTheSuspensionPointAtWhichAProcessEndsOrIsHeldUp) {
  for (const auto& [kind, place] : {std::pair("pause", 2), std::pair("agent", 2), std::pair("board", 1)}) {
    std::set<std::int64_t> points;
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      for (const Fault& fault : draw_story(programs::four_cubes(), seed, {kind}).faults) {
        points.insert(fault.what[static_cast<std::size_t>(place)].integer());
      }
    }
    EXPECT_GT(points.size(), 20U) << kind;
    EXPECT_GE(*points.begin(), 1) << kind;
  }
}

TEST(ChaosStory, DrawsJumpsOfTheClocksBothWays) {
  std::set<bool> ahead;
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    for (const Fault& fault : draw_story(programs::four_cubes(), seed, {"clock"}).faults) {
      const double by_s = fault.what[2].number();
      EXPECT_LE(std::abs(by_s), 5);
      ahead.insert(by_s > 0);
    }
  }
  EXPECT_EQ(ahead.size(), 2U);
}

}  // namespace
}  // namespace pizarra::chaos
