#include "tests/bench/loop/loop_play.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>
#include <utility>

#include "lisp/reader.hpp"
#include "lisp/writer.hpp"
#include "programs/story/scenario_run.hpp"
#include "tests/bench/loop/loop_watch.hpp"
#include "tests/bench/loop/measured_camera.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::bench {

namespace {

constexpr double within_s = 400;
// How long a grasp takes from its beginning to the grip, and a carry after it: a hand comes at any instant of it.
constexpr double grasp_s = 3.5;
constexpr double carry_s = 2.5;
// How long a cube slides, and how far at most: its neighbours stand not much further off. Then it rests for a while
// before the grip. One that is to move at the grip begins as the fingers begin to close: the eyes would notice an
// earlier slide, and the loop would follow the cube until it rests.
constexpr double longest_slide_s = 1;
constexpr double furthest_slide_mm = 45;
constexpr double rest_s = 0.3;
constexpr double off_x_mm = 25;
constexpr double off_y_mm = 15;
constexpr double off_yaw_deg = 10;
// From middle to middle: there two cubes of 60 mm have room, however they are turned.
constexpr double nearest_mm = 86;

template <class T>
void shuffle(std::vector<T>& items, Random& random) {
  for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[random.below(i)]);
}

Datum symbol(const std::string& name) { return Datum::symbol(name); }

// When `upper`'s operation of that name begins, `action` comes at any instant of so many seconds.
forms::ScenarioEvent during(Datum operation, double seconds, Datum action, Random& random) {
  const Datum condition = list("operation"_sym, "?"_sym, std::move(operation), "running"_sym);
  return {condition, {list("wait"_sym, random.uniform(0, seconds)), std::move(action)}};
}

// Aslant, to either side, at that speed.
forms::ScenarioEvent slide(const Datum& cube, const Disturbance& disturbance, Random& random) {
  const double speed = disturbance.slide_mm_s;
  const double way_mm = std::min(speed * longest_slide_s, furthest_slide_mm);
  const double along_mm = way_mm / std::numbers::sqrt2;
  const double dx_mm = random.below(2) == 0 ? along_mm : -along_mm;
  const double dy_mm = random.below(2) == 0 ? along_mm : -along_mm;
  const Datum action = list("hand"_sym, "slide"_sym, cube, dx_mm, dy_mm, speed);
  const Datum pick_up = list("PICK-UP"_sym, cube);
  if (!disturbance.at_the_grip) return during(pick_up, grasp_s - way_mm / speed - rest_s, action, random);
  const Datum picked_up = list("operation"_sym, "?"_sym, pick_up, "running"_sym);
  const Datum closes = list("micro-task"_sym, "?"_sym, list("close"_sym), "running"_sym);
  return {list("and"_sym, picked_up, closes), {action}};
}

struct Start {
  forms::CellDescription cell;
  std::vector<forms::CubePlacement> tower;  // from the bottom up
};

Start drawn_start(forms::CellDescription cell, int cubes, Random& random) {
  shuffle(cell.cubes, random);
  cell.cubes.resize(static_cast<std::size_t>(cubes));
  const double share_mm = (cell.row.y_high_mm - cell.row.y_low_mm) / cubes;
  const double room_mm = std::min(off_y_mm, (share_mm - nearest_mm) / 2);
  for (int i = 0; i < cubes; ++i) {
    forms::CubePlacement& cube = cell.cubes[static_cast<std::size_t>(i)];
    cube.x_mm = cell.row.x_mm + random.uniform(-off_x_mm, off_x_mm);
    cube.y_mm = cell.row.y_low_mm + (i + 0.5) * share_mm + random.uniform(-room_mm, room_mm);
    cube.yaw_deg = random.uniform(-off_yaw_deg, off_yaw_deg);
    cube.on.clear();
  }
  std::vector<forms::CubePlacement> tower = cell.cubes;
  shuffle(tower, random);
  return {std::move(cell), std::move(tower)};
}

forms::Scenario scenario_of(const Start& start, const Disturbance& disturbance, Random& random) {
  forms::Scenario scenario;
  scenario.name = "loop";
  scenario.within_s = within_s;
  if (disturbance.slip_chance > 0) {
    scenario.before_goal.push_back(
        list("fingers"_sym, "slips"_sym, disturbance.slip_chance, disturbance.slip_draws, disturbance.slip_within_s));
  }
  if (disturbance.misplace > 0)
    scenario.before_goal.push_back(list("fingers"_sym, "misplace"_sym, disturbance.misplace));
  for (std::size_t i = 1; i < start.tower.size(); ++i) {
    const forms::CubePlacement& cube = start.tower[i];
    const Datum upper = symbol(cube.name);
    const Datum lower = symbol(start.tower[i - 1].name);
    scenario.goal.push_back(list("on"_sym, upper, lower));
    if (disturbance.moved) {
      const Datum push = list("hand"_sym, "push"_sym, upper, random.uniform(-20, 20), random.uniform(-50, 50));
      scenario.events.push_back(during(list("PICK-UP"_sym, upper), grasp_s, push, random));
    }
    if (disturbance.slide_mm_s > 0) scenario.events.push_back(slide(upper, disturbance, random));
    if (disturbance.removed) {
      // To where it stood, or near: the room is its own.
      const Datum place = list("hand"_sym, "place"_sym, upper, cube.x_mm + random.uniform(-off_x_mm, off_x_mm),
                               cube.y_mm + random.uniform(-off_y_mm, off_y_mm));
      scenario.events.push_back(during(list("STACK"_sym, upper, lower), carry_s, place, random));
    }
  }
  return scenario;
}

Datum numbers(const std::vector<double>& values) {
  std::vector<Datum> items;
  for (const double value : values) items.push_back(to_datum(value));
  return Datum::list(std::move(items));
}

std::vector<double> numbers_of(const Datum& items) {
  std::vector<double> values;
  for (const Datum& item : items.items()) values.push_back(item.number());
  return values;
}

Datum parts_of(const std::vector<Retry>& retries) {
  std::vector<Datum> items;
  for (const Retry& retry : retries) items.push_back(numbers({retry.part_s.begin(), retry.part_s.end()}));
  return Datum::list(std::move(items));
}

std::vector<Retry> retries_of(const Datum& items) {
  std::vector<Retry> retries;
  for (const Datum& item : items.items()) {
    const std::vector<double> parts_s = numbers_of(item);
    std::ranges::copy(parts_s, retries.emplace_back().part_s.begin());
  }
  return retries;
}

}  // namespace

Played play_loop(const Disturbance& disturbance, std::uint64_t seed, bool open_loop, bool told) {
  Played played;
  Result<forms::CellDescription> cell = forms::read_cell_file(source_dir() + "/examples/01-blocks/cell.scm");
  if (!cell) return {.end = describe(cell.error())};
  cell->camera = measured_camera;
  Random random = Random(seed).split("loop");
  Start start = drawn_start(std::move(*cell), disturbance.cubes, random);
  start.cell.open_loop = open_loop;
  const forms::Scenario scenario = scenario_of(start, disturbance, random);
  LoopWatch watch;
  story::Narrator narrator(stdout, told ? story::Narrator::Style::plain : story::Narrator::Style::silent);
  story::StoryOptions options;
  options.seed = seed;
  options.director.events_may_fail = true;
  options.beside = [&watch](launcher::LocalCell& playing) { return watch.follow(playing); };
  const Result<story::StoryReport> run = story::run_story(scenario, start.cell, options, narrator);
  if (!run) return {.end = describe(run.error())};
  played.reached = run->director.reached();
  played.took_s = static_cast<double>(run->director.took.count()) / 1e6;
  played.cell_s = static_cast<double>(run->simulated.count()) / 1e6;
  played.wall_s = run->wall_s;
  played.end = run->director.outcome;
  if (run->director.refusal) {
    const char* in_the_world = run->director.possible ? ", though a plan exists" : ", and no plan exists";
    played.end += fmt::format(" ({}{})", run->director.refusal->symbol, in_the_world);
  }
  if (played.end == "reached" && !played.reached) played.end += ", but not so in the world";
  played.decisions_s = watch.decisions_s();
  played.kept = watch.kept();
  played.carries_s = watch.carries_s();
  played.grips_mm_s = watch.grips_mm_s();
  played.retries = watch.retries();
  return played;
}

std::string played_to_text(const Played& played) {
  return write(list(played.reached ? "yes"_sym : "no"_sym, played.took_s, played.cell_s, played.wall_s,
                    to_datum(played.end), numbers(played.decisions_s), numbers(played.kept), numbers(played.carries_s),
                    numbers(played.grips_mm_s), parts_of(played.retries)));
}

Played played_from_text(const std::string& text) {
  const Result<Datum> told = read_one(text);
  if (!told || told->size() != 10) return {.end = "died"};
  const Datum& d = *told;
  return {d[0].is_symbol("yes"), d[1].number(),    d[2].number(),    d[3].number(),    std::string(d[4].text()),
          numbers_of(d[5]),      numbers_of(d[6]), numbers_of(d[7]), numbers_of(d[8]), retries_of(d[9])};
}

}  // namespace pizarra::bench
