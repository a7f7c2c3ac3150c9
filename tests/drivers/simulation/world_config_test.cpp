#include <fmt/format.h>

#include "lisp/forms/cell_file.hpp"
#include "tests/drivers/simulation/bench.hpp"

namespace pizarra::simulation {

namespace {

std::string fault(const WorldConfig& config) {
  const Result<void> checked = check(config);
  return checked ? "" : checked.error().sentence;
}

// Reads a cell file with `count` things, each as `form` writes it at a place of its own. Answers the
// error's sentence, or nothing.
std::string fault_of_file(std::size_t count, fmt::format_string<std::size_t&, std::size_t&, int&> form) {
  std::string world;
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t x_mm = 260 + 90 * (i % 5);
    int y_mm = 90 * static_cast<int>(i / 5) - 180;
    world += fmt::format(form, i, x_mm, y_mm);
  }
  const Result<forms::CellDescription> cell = forms::read_cell("(cell c (world " + world + "))", "c");
  return cell ? "" : cell.error().sentence;
}

}  // namespace

TEST(WorldConfig, AcceptsARowAndATower) {
  WorldConfig config = four_cubes();
  config.cubes[3].on = "circle";
  EXPECT_EQ(fault(config), "");
  EXPECT_EQ(fault(WorldConfig()), "");
}

TEST(WorldConfig, SaysWhatIsWrong) {
  WorldConfig config = four_cubes();
  config.cubes[1].name = "Circle";
  EXPECT_EQ(fault(config), "two cubes are called Circle");
  config = four_cubes();
  config.cubes[0].name = "a cube";
  EXPECT_EQ(fault(config), "\"a cube\" is no name for a cube");
  config = four_cubes();
  config.cubes[0].on = "cross";
  EXPECT_EQ(fault(config), "circle stands on cross, which is not listed before it");
  config = four_cubes();
  config.cubes[1].on = "circle";
  config.cubes[2].on = "circle";
  EXPECT_EQ(fault(config), "cross and square stand on the same cube");
  config = four_cubes();
  config.cubes[2].y_mm = -20;
  EXPECT_EQ(fault(config), "cross and square stand in one place");
  config = four_cubes();
  config.cubes[2].x_mm = 900;
  EXPECT_EQ(fault(config), "square does not stand on the table");
  config = four_cubes();
  config.camera.model.focal_px = 0;
  EXPECT_EQ(fault(config), "the camera's figures are out of range");
  config = four_cubes();
  config.cubes.resize(max_cubes + 1);
  EXPECT_EQ(fault(config), "a cell has at most 16 cubes");
}

TEST(WorldConfig, HasTheBoundsOfCellFiles) {
  const auto cubes = [](std::size_t count) { return fault_of_file(count, "(cube c{} (mark circle) (at {} {}))"); };
  EXPECT_EQ(cubes(max_cubes), "");
  EXPECT_NE(cubes(max_cubes + 1).find(fmt::format("a cell has at most {} cubes", max_cubes)), std::string::npos);
  const auto things = [](std::size_t count) { return fault_of_file(count, "(brick b{} (size 40 40 40) (at {} {}))"); };
  EXPECT_EQ(things(max_things), "");
  EXPECT_NE(things(max_things + 1).find(fmt::format("at most {} bricks and cylinders", max_things)), std::string::npos);
}

TEST(WorldConfig, NamesMarksBothWays) {
  for (const Mark mark : {Mark::circle, Mark::square, Mark::cross, Mark::triangle}) {
    EXPECT_EQ(mark_from_name(mark_name(mark)), mark);
  }
  EXPECT_FALSE(mark_from_name("moon"));
}

}  // namespace pizarra::simulation
