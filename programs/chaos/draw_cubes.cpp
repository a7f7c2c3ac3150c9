#include "programs/chaos/draw_cubes.hpp"

#include <algorithm>
#include <cmath>

#include "drivers/simulation/face_mark.hpp"
#include "programs/chaos/draw_camera.hpp"

namespace pizarra::chaos {

namespace {

constexpr std::size_t fewest_cubes = 3;
constexpr std::size_t most_cubes = 5;
constexpr std::uint64_t one_more_in = 4;  // runs has a cube more
constexpr double wide_row_mm = 245;       // to either side: a row for five
constexpr double smallest_mm = 48;        // with more noise the marks of smaller cubes are not always learned

constexpr std::uint64_t many_in = 8;  // cells has six to eight cubes
constexpr std::size_t fewest_of_many = 6;
constexpr double widest_row_mm = 310;  // to either side: a row for eight
// From there the cameras see all of that row. Their images show a cube as large as usual.
constexpr double farther_mm = 300;
// With 40 mm between two, all of them stand in the row.
constexpr double smallest_of_many_mm = 42;
constexpr double largest_of_many_mm = 48;

void widen_row(forms::CellDescription& cell, double aside_mm) {
  cell.row.y_low_mm = std::min(cell.row.y_low_mm, -aside_mm);
  cell.row.y_high_mm = std::max(cell.row.y_high_mm, aside_mm);
}

// Another cube, with a mark that no other has.
void add_cube(forms::CellDescription& cell, Random& random) {
  std::vector<std::string> marks;
  for (const std::string_view mark : simulation::mark_names()) {
    const auto wears_it = [&](const forms::CubePlacement& cube) { return cube.mark == mark || cube.name == mark; };
    if (std::ranges::none_of(cell.cubes, wears_it)) marks.emplace_back(mark);
  }
  const std::string& mark = marks[random.below(marks.size())];
  forms::CubePlacement& cube = cell.cubes.emplace_back();
  cube.name = mark;
  cube.mark = mark;
  cube.edge_mm = cell.cube_mm;
}

bool has_one_size(const forms::CellDescription& cell) {
  return std::ranges::all_of(cell.cubes, [&](const forms::CubePlacement& c) { return c.edge_mm == cell.cube_mm; });
}

// All cubes get this edge, and the gripper opens as much more or less for them.
void resize_cubes(forms::CellDescription& cell, double edge_mm) {
  const double by_mm = edge_mm - cell.cube_mm;
  for (forms::CubePlacement& cube : cell.cubes) cube.edge_mm = edge_mm;
  for (double* opening : {&cell.openings.narrow_mm, &cell.openings.normal_mm, &cell.openings.wide_mm}) {
    *opening += by_mm;
  }
  cell.cube_mm = edge_mm;
}

void draw_many(forms::CellDescription& cell, Random random) {
  const std::size_t count = fewest_of_many + random.below(3);
  while (cell.cubes.size() < count) add_cube(cell, random);
  const double size_mm = std::floor(random.uniform(smallest_of_many_mm, largest_of_many_mm + 1));
  resize_cubes(cell, std::min(cell.cube_mm, size_mm));
  widen_row(cell, widest_row_mm);
  cell.world_camera.at_mm[0] += farther_mm;
  cell.camera.pose.at_mm[0] += farther_mm;
  take_larger_images(cell);
}

}  // namespace

void draw_cubes(forms::CellDescription& cell, Random& random) {
  Random more = random.split("more cubes");
  Random size = random.split("size");
  const Random many = random.split("many cubes");
  if (cell.cubes.size() > fewest_cubes && random.below(3) == 0) {
    cell.cubes.erase(cell.cubes.begin() + static_cast<std::ptrdiff_t>(random.below(cell.cubes.size())));
  }
  if (cell.cubes.size() < most_cubes && more.below(one_more_in) == 0) {
    add_cube(cell, more);
    widen_row(cell, wide_row_mm);
  }
  if (!has_one_size(cell) || has_tags_of_its_own(cell)) return;
  if (cell.cube_mm > smallest_mm && size.below(2) == 0) {
    const auto sizes = static_cast<std::uint64_t>(cell.cube_mm - smallest_mm) + 1;
    resize_cubes(cell, cell.cube_mm - static_cast<double>(size.below(sizes)));
  }
  if (many.split("whether").below(many_in) == 0) draw_many(cell, many.split("which"));
}

bool has_tags_of_its_own(const forms::CellDescription& cell) { return !cell.tagged.empty() || !cell.bodies.empty(); }

bool has_many_cubes(const forms::CellDescription& cell) { return cell.cubes.size() > most_cubes; }

}  // namespace pizarra::chaos
