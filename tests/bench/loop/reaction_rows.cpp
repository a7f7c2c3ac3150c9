// How soon the arm is commanded otherwise after a frame that shows its target elsewhere, by frames a second.

#include <array>
#include <cstdio>
#include <fmt/format.h>

#include "tests/bench/loop/reaction_cell.hpp"
#include "tests/bench/loop/rows.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

struct Reaction {
  const char* name;
  int frames_per_s;
};

constexpr std::array<Reaction, 3> reactions{{{"reaction-10", 10}, {"reaction-30", 30}, {"reaction-60", 60}}};
constexpr double goal_frames = 1.1;
constexpr std::chrono::minutes longest{5};

void measure(LoopBench& bench, const Reaction& row) {
  ReactionCell cell(row.frames_per_s, bench.first_seed);
  const std::vector<double> reactions_s = cell.measure(bench.shoves, longest);
  const double late_s = percentile(reactions_s, 0.99);
  const double frames = late_s * row.frames_per_s;
  const bool met = !reactions_s.empty() && frames <= goal_frames;
  fmt::print("row {} shoves {} median {:.1f} ms, 99 % {:.1f} ms, {:.2f} frames goal {:g} {}\n", row.name,
             reactions_s.size(), 1000 * percentile(reactions_s, 0.5), 1000 * late_s, frames, goal_frames,
             bench.judge(met));
  std::fflush(stdout);
}

}  // namespace

std::vector<std::string> reaction_row_names() {
  std::vector<std::string> names;
  for (const Reaction& row : reactions) names.emplace_back(row.name);
  return names;
}

void reaction_rows(LoopBench& bench) {
  if (bench.replay) return;
  for (const Reaction& row : reactions) {
    if (bench.wants(row.name)) measure(bench, row);
  }
}

}  // namespace pizarra::bench
