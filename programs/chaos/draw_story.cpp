#include "programs/chaos/draw_story.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "lisp/writer.hpp"
#include "programs/chaos/draw_camera.hpp"
#include "programs/chaos/draw_cubes.hpp"
#include "programs/chaos/draw_faults.hpp"
#include "programs/chaos/draw_marks.hpp"
#include "programs/chaos/draw_scenery.hpp"
#include "programs/story/random_story.hpp"

namespace pizarra::chaos {

namespace {

constexpr double shortest_phase_s = 12;
constexpr double longest_phase_s = 40;
constexpr std::uint64_t one_class_in = 4;  // is in a run
constexpr Duration clocks_apart = std::chrono::minutes(2);
constexpr double clocks_drift = 2e-4;

forms::CellDescription draw_cell(forms::CellDescription cell, Random& random) {
  draw_cubes(cell, random);
  cell.noise.sensor_grey = random.uniform(1, 5);
  cell.noise.blur_px = random.uniform(0.5, 0.9);
  cell.noise.gradient = random.uniform(0.02, 0.2);
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
  draw_marks(drawn, random.split("marks"));
  draw_scenery(drawn, random.split("scenery"));
  const story::RandomStory first = story::random_story(drawn, random.split("story"));
  story.cell = first.cell;
  draw_head(story.cell, random.split("head"));
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

std::vector<std::string> special_about(const forms::CellDescription& cell) {
  std::vector<std::string> words;
  if (has_many_cubes(cell)) words.emplace_back("many-cubes");
  if (has_tagged_cubes(cell)) words.emplace_back("tags");
  if (has_bodies(cell)) words.emplace_back("bodies");
  if (!cell.head.empty()) words.emplace_back("head");
  return words;
}

std::vector<std::string> describe(const ChaosStory& story) {
  std::vector<std::string> lines;
  std::string cubes;
  for (const forms::CubePlacement& cube : story.cell.cubes) cubes += (cubes.empty() ? "" : ", ") + cube_text(cube);
  const forms::CellNoise& noise = story.cell.noise;
  lines.push_back(fmt::format("cubes of {} mm: {}; noise: sensor {:.1f}, blur {:.2f}, gradient {:.2f}",
                              story.cell.cube_mm, cubes, noise.sensor_grey, noise.blur_px, noise.gradient));
  lines.push_back(describe_camera(story.cell));
  if (!story.cell.head.empty()) lines.push_back("the cameras stand on a pan-tilt unit: " + story.cell.head);
  lines.push_back(fmt::format("images of {}x{}", story.cell.image.width_px, story.cell.image.height_px));
  for (std::string& line : describe_marks(story.cell)) lines.push_back(std::move(line));
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
