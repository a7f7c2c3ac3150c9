// How soon the arm is commanded otherwise after a frame that shows its target elsewhere, by frames a second.

#include <algorithm>
#include <array>
#include <cstdio>
#include <fmt/format.h>

#include "tests/bench/loop/reaction_cell.hpp"
#include "tests/bench/loop/rows.hpp"
#include "tests/bench/loop/share.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

struct Reaction {
  const char* name;
  int frames_per_s;
};

constexpr std::array<Reaction, 3> reactions{{{"reaction-10", 10}, {"reaction-30", 30}, {"reaction-60", 60}}};
constexpr double goal_frames = 1.1;
constexpr double goal_percent = 99;
// A row ends after this, with as many shoves as came.
constexpr std::chrono::seconds longest{50};

// Of the same form as the other rows. An open loop never reacts.
void measure(LoopBench& bench, const Reaction& row) {
  fmt::print(stderr, "{}: the cell's processes begin\n", row.name);
  ReactionCell cell(row.frames_per_s, bench.first_seed);
  const auto tell = [&](std::size_t answered) {
    fmt::print(stderr, "{}: {} of {} shoves answered\n", row.name, answered, bench.shoves);
  };
  const std::vector<double> reactions_s = cell.measure(bench.shoves, longest, tell);
  const auto runs = static_cast<int>(reactions_s.size());
  const double longest_s = goal_frames / row.frames_per_s;
  const auto in_time =
      static_cast<int>(std::ranges::count_if(reactions_s, [&](double took_s) { return took_s <= longest_s; }));
  const Share share = share_of(in_time, runs);
  const double late_s = percentile(reactions_s, 0.99);
  fmt::print("row {} runs {} reached {} low {:.1f} high {:.1f} ratio {:.2f} open 0.0 goal {:g} {}\n", row.name, runs,
             in_time, share.low, share.high, late_s * row.frames_per_s, goal_percent,
             bench.judge(runs > 0 && share.percent >= goal_percent));
  fmt::print("    reached: within {:g} frame periods; median {:.1f} ms, 99 % {:.1f} ms\n", goal_frames,
             1000 * percentile(reactions_s, 0.5), 1000 * late_s);
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
