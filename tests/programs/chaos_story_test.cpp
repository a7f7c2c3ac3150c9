// What a run under faults draws from its seed.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <set>

#include "agents/launcher/agent_factory.hpp"
#include "programs/chaos/draw_cubes.hpp"
#include "programs/chaos/draw_story.hpp"
#include "tests/programs/four_cubes.hpp"

namespace pizarra::chaos {
namespace {

TEST(ChaosStory, DrawsThreeToFiveCubesOfSeveralSizesWithMarksOfTheirOwnAndInSomeCellsSixToEight) {
  std::map<bool, std::set<std::size_t>> counts;  // by whether they are many
  std::map<bool, std::set<double>> sizes;
  std::set<std::string> marks;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const forms::CellDescription cell = draw_story(programs::four_cubes(), seed, {}).cell;
    EXPECT_TRUE(launcher::world_config(cell, seed)) << "seed " << seed;
    const bool many = has_many_cubes(cell);
    counts[many].insert(cell.cubes.size());
    sizes[many].insert(cell.cube_mm);
    std::set<std::string> own;
    for (const forms::CubePlacement& cube : cell.cubes) {
      EXPECT_EQ(cube.edge_mm, cell.cube_mm) << "seed " << seed;
      EXPECT_TRUE(own.insert(cube.mark).second) << "seed " << seed << ", " << cube.mark;
      if (simulation::mark_from_name(cube.mark)) marks.insert(cube.mark);
    }
  }
  EXPECT_EQ(counts[false], (std::set<std::size_t>{3, 4, 5}));
  EXPECT_EQ(counts[true], (std::set<std::size_t>{6, 7, 8}));
  EXPECT_EQ(*sizes[false].begin(), 48);
  EXPECT_EQ(*sizes[false].rbegin(), 60);
  EXPECT_EQ(*sizes[true].begin(), 42);
  EXPECT_EQ(*sizes[true].rbegin(), 48);
  EXPECT_EQ(marks.size(), 12U);
}

// In the same part of their larger images.
TEST(ChaosStory, SeesManyCubesFromFartherAwayInLargerImages) {
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const forms::CellDescription cell = draw_story(programs::four_cubes(), seed, {}).cell;
    if (!has_many_cubes(cell)) continue;
    EXPECT_EQ(cell.image.width_px, 640);
    EXPECT_EQ(cell.world_camera.at_mm[0], programs::four_cubes().world_camera.at_mm[0] + 300);
    EXPECT_GE(cell.row.y_high_mm - cell.row.y_low_mm, 620);
  }
}

// Of 300 stories.
int cells_with(const std::function<bool(const forms::CellDescription&)>& thing) {
  int cells = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    if (thing(draw_story(programs::four_cubes(), seed, {}).cell)) ++cells;
  }
  return cells;
}

bool has_lamp(const forms::CellDescription& cell) { return cell.second_lamp.has_value(); }
bool has_lens(const forms::CellDescription& cell) { return cell.lens[0] != 0; }
bool has_wall(const forms::CellDescription& cell) { return cell.background.has_value(); }
bool has_table(const forms::CellDescription& cell) { return cell.table_picture.has_value(); }

TEST(ChaosStory, DrawsALampALensAndPhotographsForSomeCellsEachOnItsOwn) {
  for (const auto& thing : {has_lamp, has_lens, has_wall, has_table}) {
    EXPECT_GT(cells_with(thing), 15);
    EXPECT_LT(cells_with(thing), 75);
  }
  EXPECT_GT(cells_with([](const auto& cell) { return has_lamp(cell) && has_lens(cell); }), 0);
  EXPECT_GT(cells_with([](const auto& cell) { return has_lamp(cell) && !has_lens(cell); }), 10);
}

TEST(ChaosStory, DrawsEachPhotographBehindTheTableAndOnIt) {
  std::set<std::string> behind;
  std::set<std::string> on_it;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const forms::CellDescription cell = draw_story(programs::four_cubes(), seed, {}).cell;
    if (cell.background) behind.insert(cell.background->file);
    if (cell.table_picture) on_it.insert(cell.table_picture->file);
  }
  EXPECT_EQ(behind.size(), 2U);
  EXPECT_EQ(on_it, behind);
}

TEST(ChaosStory, KeepsTheSceneryThatACellsFileHas) {
  forms::CellDescription own = programs::four_cubes();
  own.second_lamp = forms::CellLamp{.at_mm = {900, -600, 1200}, .part = 0.4};
  own.lens = {-0.2, 0.05, 0, 0, 0};
  own.background = forms::CellPicture{.file = "wall.png", .named_at = ""};
  own.table_picture = forms::CellPicture{.file = "cloth.png", .named_at = ""};
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    const forms::CellDescription cell = draw_story(own, seed, {}).cell;
    EXPECT_EQ(cell.second_lamp->at_mm, own.second_lamp->at_mm);
    EXPECT_EQ(cell.lens, own.lens);
    EXPECT_EQ(cell.background->file, "wall.png");
    EXPECT_EQ(cell.table_picture->file, "cloth.png");
  }
}

// How many lines of the description of all stories begin so.
int lines_that_begin(const std::string& words) {
  int found = 0;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    for (const std::string& line : describe(draw_story(programs::four_cubes(), seed, {}))) {
      if (line.starts_with(words)) ++found;
    }
  }
  return found;
}

TEST(ChaosStory, SaysTheSceneryOfEachCellThatHasSome) {
  EXPECT_EQ(lines_that_begin("a lamp at "), cells_with(has_lamp));
  EXPECT_EQ(lines_that_begin("lenses with k1 "), cells_with(has_lens));
  EXPECT_EQ(lines_that_begin("a photograph behind the table: "), cells_with(has_wall));
  EXPECT_EQ(lines_that_begin("a photograph on the table: "), cells_with(has_table));
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

TEST(ChaosStory, TellsTheAgentsAGuessOfTheCameraThatIsOffBy20MillimetresAnd2Degrees) {
  std::set<std::array<bool, 3>> directions;
  for (std::uint64_t seed = 1; seed <= 100; ++seed) {
    const forms::CellDescription cell = draw_story(programs::four_cubes(), seed, {}).cell;
    const forms::CameraPose& truth = cell.world_camera;
    const forms::CameraPose& guess = cell.camera.pose;
    std::array<double, 3> off{};
    for (std::size_t axis = 0; axis < off.size(); ++axis) off[axis] = guess.at_mm[axis] - truth.at_mm[axis];
    EXPECT_NEAR(std::hypot(off[0], off[1], off[2]), 20, 1e-9) << "seed " << seed;
    const double panned = guess.pan_deg - truth.pan_deg;
    EXPECT_NEAR(std::hypot(panned, guess.tilt_deg - truth.tilt_deg, guess.roll_deg - truth.roll_deg), 2, 1e-9);
    EXPECT_EQ(cell.camera.sure_mm, 20);
    EXPECT_EQ(cell.camera.sure_deg, 2);
    EXPECT_EQ(truth == programs::four_cubes().world_camera, !has_many_cubes(cell)) << "seed " << seed;
    directions.insert({off[0] > 0, off[1] > 0, off[2] > 0});
  }
  EXPECT_EQ(directions.size(), 8U);
}

TEST(ChaosStory, KeepsThePoseThatACellsFileIsSurerOf) {
  forms::CellDescription measured = programs::four_cubes();
  measured.camera.pose = measured.world_camera;
  measured.camera.pose.at_mm[2] += 7;
  measured.camera.sure_mm = 10;
  EXPECT_EQ(draw_story(measured, 1, {}).cell.camera.pose, measured.camera.pose);
  forms::CellDescription unknown = programs::four_cubes();
  unknown.camera.unknown = true;
  EXPECT_TRUE(draw_story(unknown, 1, {}).cell.camera.unknown);
}

bool has_unit(const forms::CellDescription& cell) { return !cell.head.empty(); }

TEST(ChaosStory, DrawsAPanTiltUnitUnderTheCamerasOfSomeCellsAndSaysSo) {
  EXPECT_GT(cells_with(has_unit), 15);
  EXPECT_LT(cells_with(has_unit), 75);
  EXPECT_EQ(lines_that_begin("the cameras stand on a pan-tilt unit: ptu46-17.5"), cells_with(has_unit));
  EXPECT_EQ(cells_with(has_unit), cells_with([](const auto& cell) {
              return std::ranges::count(special_about(cell), "head") == 1 && launcher::world_config(cell, 1);
            }));
}

TEST(ChaosStory, SomeUnitsThatAreDrawnAreTurnedByHand) {
  std::set<std::string> drawn;
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    for (const Fault& fault : draw_story(programs::four_cubes(), seed, {"bump"}).faults)
      drawn.emplace(fault.what.head());
  }
  EXPECT_EQ(drawn, (std::set<std::string>{"bump", "nudge"}));
}

TEST(ChaosStory, KeepsThePanTiltUnitThatACellsFileHas) {
  forms::CellDescription own = programs::four_cubes();
  own.head = "ptu46-70";
  forms::CellDescription real = programs::four_cubes();
  real.pan_tilt.kind = "tcp";
  for (std::uint64_t seed = 1; seed <= 50; ++seed) {
    EXPECT_EQ(draw_story(own, seed, {}).cell.head, "ptu46-70");
    EXPECT_EQ(draw_story(real, seed, {}).cell.head, "");
  }
}

TEST(ChaosStory, SaysWhereTheCameraStandsAndWhereTheAgentsTakeItToStand) {
  const std::vector<std::string> lines = describe(draw_story(programs::four_cubes(), 1, {}));
  const auto says = [](const std::string& line) {
    return line.starts_with("camera at 1330.0 0.0 200.0 mm, pan 0.00, tilt 0.00, roll 0.00; taken to be at ") &&
           line.ends_with(", sure to 20 mm and 2 degrees");
  };
  EXPECT_EQ(std::ranges::count_if(lines, says), 1);
}

}  // namespace
}  // namespace pizarra::chaos
