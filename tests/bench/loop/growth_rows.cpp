// How the loop's own work grows with the objects on the table and the height of the tower. Its parts are measured one
// by one. Arm and table are not measured: a cell without physics stands in for them, and for the eyes, so that there
// may be more objects than a camera's image holds.

#include <array>
#include <fmt/format.h>

#include "tests/agents/coordinator/fake_cell.hpp"
#include "tests/bench/loop/loop_parts.hpp"
#include "tests/bench/loop/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

using coordinator::FakeCell;

struct Growth {
  const char* name;
  int objects;
  int tower;
};

constexpr std::array<Growth, 6> growths{{{"objects-4", 4, 4},
                                         {"objects-8", 8, 4},
                                         {"objects-12", 12, 4},
                                         {"objects-24", 24, 4},
                                         {"tower-of-5", 12, 5},
                                         {"tower-of-6", 12, 6}}};
constexpr int looks = 100;
constexpr Duration look_period = 100ms;
constexpr Duration patience = std::chrono::minutes(10);

std::string name_of(int cube) { return fmt::format("c{}", cube); }

// Five in a row, far enough apart for the fingers.
FakeCell::Cubes field(int objects) {
  constexpr int in_a_row = 5;
  FakeCell::Cubes cubes;
  for (int i = 0; i < objects; ++i) {
    const int row = i / in_a_row;
    cubes[name_of(i)] = {250.0 + 100 * row, -200.0 + 100 * (i % in_a_row), 30};
  }
  return cubes;
}

std::string goal_of(int tower) {
  std::string goal = "(goal";
  for (int i = 1; i < tower; ++i) goal += fmt::format(" (on {} {})", name_of(i), name_of(i - 1));
  return goal + ")";
}

// From further away and higher up than the other cells' camera: the whole field and a tower of six are in view.
void set_camera(FakeCell& cell) {
  cell.camera.at_mm = {1900, 0, 300};
  cell.believed.pose = cell.camera;
  cell.travel_mm = 420;
}

void measure(const Growth& growth) {
  FakeCell cell("blocks.scm", field(growth.objects));
  set_camera(cell);
  cell.start_coordinator();
  cell.request("coordinator", goal_of(growth.tower));
  bool reached = false;
  Duration took{};
  const double worked_s = seconds_of([&] {
    const Time begun = cell.now();
    reached = cell.run_until("(goal-state 1 reached ?)", patience);
    took = cell.now() - begun;
  });
  const double believing_s = thread_seconds_of([&] { cell.run_for(looks * look_period); });
  const double cell_s = std::chrono::duration<double>(took).count();
  const std::optional<double> look_s = look_seconds(growth.objects);
  const PlanSeconds planner_s = plan_seconds(growth.objects, growth.tower);
  fmt::print(
      "growth {} objects {} tower {} {}: look {}, believe {:.3f} ms, plan {:.2f} ms, choose {:.3f} ms; {:.0f} s of the "
      "cell's time, {:.0f} times faster than real time\n",
      growth.name, growth.objects, growth.tower, reached ? "reached" : "NOT REACHED",
      look_s ? fmt::format("{:.3f} ms", 1000 * *look_s) : "told", 1000 * believing_s / looks, 1000 * planner_s.plan,
      1000 * planner_s.choose, cell_s, cell_s / worked_s);
  std::fflush(stdout);
}

}  // namespace

std::vector<std::string> growth_row_names() {
  std::vector<std::string> names;
  for (const Growth& growth : growths) names.emplace_back(growth.name);
  return names;
}

void growth_rows(const LoopBench& bench) {
  if (bench.replay) return;
  for (const Growth& growth : growths) {
    if (bench.wants(growth.name)) measure(growth);
  }
}

}  // namespace pizarra::bench
