#include "programs/chaos/draw_story.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "drivers/simulation/world_config.hpp"
#include "lisp/writer.hpp"
#include "programs/chaos/draw_camera.hpp"
#include "programs/chaos/draw_faults.hpp"
#include "programs/chaos/draw_scenery.hpp"
#include "programs/story/random_story.hpp"

namespace pizarra::chaos {

namespace {

constexpr double shortest_phase_s = 12;
constexpr double longest_phase_s = 40;
constexpr std::uint64_t one_class_in = 4;  // is in a run
constexpr Duration clocks_apart = std::chrono::minutes(2);
constexpr double clocks_drift = 2e-4;
constexpr std::size_t fewest_cubes = 3;
constexpr std::size_t most_cubes = 5;
constexpr std::uint64_t one_more_in = 4;  // runs has a cube more
constexpr double wide_row_mm = 245;       // to either side: a row for five
constexpr double smallest_mm = 48;        // with more noise the marks of smaller cubes are not always learned

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
  cell.row.y_low_mm = std::min(cell.row.y_low_mm, -wide_row_mm);
  cell.row.y_high_mm = std::max(cell.row.y_high_mm, wide_row_mm);
}

// All cubes smaller, and the gripper opens less for them.
void shrink_cubes(forms::CellDescription& cell, double by_mm) {
  for (forms::CubePlacement& cube : cell.cubes) cube.edge_mm -= by_mm;
  for (double* opening : {&cell.openings.narrow_mm, &cell.openings.normal_mm, &cell.openings.wide_mm}) {
    *opening -= by_mm;
  }
  cell.cube_mm -= by_mm;
}

bool has_one_size(const forms::CellDescription& cell) {
  return std::ranges::all_of(cell.cubes, [&](const forms::CubePlacement& c) { return c.edge_mm == cell.cube_mm; });
}

forms::CellDescription draw_cell(forms::CellDescription cell, Random& random) {
  Random more = random.split("more cubes");
  Random size = random.split("size");
  if (cell.cubes.size() > fewest_cubes && random.below(3) == 0) {
    cell.cubes.erase(cell.cubes.begin() + static_cast<std::ptrdiff_t>(random.below(cell.cubes.size())));
  }
  cell.noise.sensor_grey = random.uniform(1, 5);
  cell.noise.blur_px = random.uniform(0.5, 0.9);
  cell.noise.gradient = random.uniform(0.02, 0.2);
  if (cell.cubes.size() < most_cubes && more.below(one_more_in) == 0) add_cube(cell, more);
  if (has_one_size(cell) && cell.cube_mm > smallest_mm && size.below(2) == 0) {
    const auto sizes = static_cast<std::uint64_t>(cell.cube_mm - smallest_mm) + 1;
    shrink_cubes(cell, static_cast<double>(size.below(sizes)));
  }
  return cell;
}

std::vector<std::string> draw_classes(const std::vector<std::string>& only, Random& random) {
  std::vector<std::string> candidates = only;
  if (candidates.empty()) {
    for (const FaultClass& kind : fault_classes()) candidates.emplace_back(kind.name);
  }
  std::vector<std::string> classes;
  for (const std::string& kind : candidates) {
    if (random.below(one_class_in) == 0) classes.push_back(kind);
  }
  if (classes.empty()) classes.push_back(candidates[random.below(candidates.size())]);
  return classes;
}

bool has(const std::vector<std::string>& classes, std::string_view name) {
  return std::ranges::find(classes, name) != classes.end();
}

std::string facts_text(const std::vector<Datum>& facts) {
  std::string text;
  for (const Datum& fact : facts) text += (text.empty() ? "" : " ") + write(fact);
  return text;
}

std::string cube_text(const forms::CubePlacement& cube) {
  if (!cube.on.empty()) return fmt::format("{} on {}", cube.name, cube.on);
  return fmt::format("{} at {:.0f} {:.0f}", cube.name, cube.x_mm, cube.y_mm);
}

}  // namespace

ChaosStory draw_story(const forms::CellDescription& cell, std::uint64_t seed, const std::vector<std::string>& only) {
  const Random random = Random(seed).split("chaos");
  Random of_cell = random.split("cell");
  Random of_goals = random.split("goals");
  Random of_classes = random.split("classes");
  ChaosStory story;
  story.seed = seed;
  forms::CellDescription drawn = draw_cell(cell, of_cell);
  draw_scenery(drawn, random.split("scenery"));
  const story::RandomStory first = story::random_story(drawn, random.split("story"));
  story.cell = first.cell;
  guess_camera(story.cell, random.split("camera"));
  story.goals.push_back(first.scenario.goal);
  for (std::uint64_t more = of_goals.below(5); more >= 3 && story.goals.size() < 3; --more) {
    const auto next = random.split("goal " + std::to_string(story.goals.size()));
    story.goals.push_back(story::random_story(drawn, next).scenario.goal);
  }
  story.fault_phase_s = of_cell.uniform(shortest_phase_s, longest_phase_s);
  story.classes = draw_classes(only, of_classes);
  if (has(story.classes, "clock")) story.clocks = {.apart = clocks_apart, .drift = clocks_drift};
  for (const std::string& kind : story.classes) {
    const std::vector<Fault> faults =
        draw_faults(kind, story.cell, story.goals.front(), story.fault_phase_s, random.split("faults " + kind));
    story.faults.insert(story.faults.end(), faults.begin(), faults.end());
  }
  return story;
}

std::vector<std::string> describe(const ChaosStory& story) {
  std::vector<std::string> lines;
  std::string cubes;
  for (const forms::CubePlacement& cube : story.cell.cubes) cubes += (cubes.empty() ? "" : ", ") + cube_text(cube);
  const forms::CellNoise& noise = story.cell.noise;
  lines.push_back(fmt::format("cubes of {} mm: {}; noise: sensor {:.1f}, blur {:.2f}, gradient {:.2f}",
                              story.cell.cube_mm, cubes, noise.sensor_grey, noise.blur_px, noise.gradient));
  lines.push_back(describe_camera(story.cell));
  for (std::string& line : describe_scenery(story.cell)) lines.push_back(std::move(line));
  for (const std::vector<Datum>& goal : story.goals) lines.push_back("goal: " + facts_text(goal));
  std::string classes;
  for (const std::string& kind : story.classes) classes += " " + kind;
  lines.push_back(fmt::format("faults for {:.1f} s, of:{}", story.fault_phase_s, classes));
  for (std::size_t i = 0; i < story.faults.size(); ++i) {
    lines.push_back(fmt::format("fault {}: {}", i, write(fault_to_datum(story.faults[i]))));
  }
  return lines;
}

}  // namespace pizarra::chaos
