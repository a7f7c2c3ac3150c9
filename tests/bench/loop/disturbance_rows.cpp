// Towers of three under the disturbances of a published table, beside our own open loop.

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <optional>

#include "programs/command_line/exit_codes.hpp"
#include "programs/story/seed_pool.hpp"
#include "tests/bench/loop/loop_play.hpp"
#include "tests/bench/loop/rows.hpp"
#include "tests/bench/loop/share.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr std::chrono::seconds longest_run{180};

struct Row {
  const char* name;
  Disturbance disturbance;
  double goal;                          // percent
  std::optional<double> longest_ratio;  // of the time, to that without a disturbance
  const char* published;                // percent, of the tables that are compared with
};

const std::vector<Row>& table() {
  static const std::vector<Row> rows{
      {"p=0", {}, 99, {}, "open loop, IM, DoReMi, CaM: not told"},
      {"p=0.15",
       {.slip_chance = 0.15},
       99,
       1.4,
       "open loop 56.7, IM 81.7 (2.60x), DoReMi 83.3 (1.94x), CaM 95.0 (1.57x)"},
      {"p=0.3",
       {.slip_chance = 0.3},
       98,
       1.7,
       "open loop 21.7, IM 75.0 (3.19x), DoReMi 76.7 (2.55x), CaM 88.3 (1.90x)"},
      {"q=0.25", {.misplace = 0.25}, 98.3, {}, "open loop 90.0, IM 90.0, DoReMi 96.7, CaM 98.3"},
      {"q=0.5", {.misplace = 0.5}, 95, {}, "open loop 41.7, IM 71.7, DoReMi 75.0, CaM 83.3"},
      {"q=0.75", {.misplace = 0.75}, 95, {}, "open loop 15.0, IM 40.0, DoReMi 40.0, CaM 63.3"},
      {"moved", {.moved = true}, 99, {}, "CaM 93 to 97, on a real robot"},
      {"slid-20", {.slide_mm_s = 20}, 99, {}, "the thesis' Fig. 6.37, without figures; at rest 0.3 s before the grip"},
      {"slid-50", {.slide_mm_s = 50}, 99, {}, "as above"},
      {"slid-100", {.slide_mm_s = 100}, 99, {}, "as above"},
      {"sliding-20", {.slide_mm_s = 20, .at_the_grip = true}, 90, {}, "none; it still moves at the grip"},
      {"sliding-50", {.slide_mm_s = 50, .at_the_grip = true}, 90, {}, "as above"},
      {"sliding-100", {.slide_mm_s = 100, .at_the_grip = true}, 90, {}, "as above"},
      {"removed", {.removed = true}, 99, {}, "CaM 90 to 97, on a real robot"},
      {"tower-4", {.slip_chance = 0.15, .cubes = 4}, 98, {}, "not told; p=0.15 with four cubes"},
  };
  return rows;
}

std::vector<Played> play(const LoopBench& bench, const Disturbance& disturbance, bool open_loop) {
  story::SeedPool pool({.first = bench.first_seed,
                        .seeds = static_cast<std::uint64_t>(bench.seeds),
                        .jobs = bench.jobs,
                        .longest = longest_run},
                       [&](std::uint64_t seed) { return played_to_text(play_loop(disturbance, seed, open_loop)); });
  std::vector<Played> out;
  const story::SeedPool::End end = pool.run([&](std::uint64_t, const story::SeedPool::Answer& answer) {
    out.push_back(played_from_text(answer.text));
    return true;
  });
  if (end != story::SeedPool::End::heard) {
    fmt::print(stderr, "interrupted: this row is not measured\n");
    std::exit(programs::exit_interrupted);
  }
  return out;
}

int reached(const std::vector<Played>& runs) { return static_cast<int>(std::ranges::count_if(runs, &Played::reached)); }

double mean(const std::vector<double>& values) {
  return values.empty() ? 0 : std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double mean_time_s(const std::vector<Played>& runs) {
  std::vector<double> times;
  for (const Played& run : runs) {
    if (run.reached) times.push_back(run.took_s);
  }
  return mean(times);
}

std::vector<double> speeds(const std::vector<Played>& runs) {
  std::vector<double> values;
  for (const Played& run : runs) {
    if (run.wall_s > 0) values.push_back(run.cell_s / run.wall_s);
  }
  return values;
}

std::vector<double> all(const std::vector<Played>& runs, std::vector<double> Played::*part) {
  std::vector<double> values;
  for (const Played& run : runs) values.insert(values.end(), (run.*part).begin(), (run.*part).end());
  return values;
}

void say_how(const LoopBench& bench, const char* loop, const std::vector<Played>& runs) {
  std::map<std::string, int> ends;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].reached) continue;
    ++ends[runs[i].end];
    if (bench.failures)
      fmt::print("    {} seed {}: {} after {:.1f} s\n", loop, bench.first_seed + i, runs[i].end, runs[i].took_s);
  }
  for (const auto& [end, count] : ends) fmt::print("    {}, not reached: {} x {}\n", loop, count, end);
}

// How the loop took what disturbed it.
void say_decisions(const std::vector<Played>& runs) {
  const std::vector<double> decisions = all(runs, &Played::decisions_s);
  if (decisions.empty()) return;
  fmt::print(
      "    {} disturbances noticed: the plan gone on with {:.2f} s later (median), {:.2f} s (99 %); {:.0f} % of the "
      "old plan's operations kept\n",
      decisions.size(), percentile(decisions, 0.5), percentile(decisions, 0.99), 100 * mean(all(runs, &Played::kept)));
}

// Answers the mean time to the goal; `undisturbed_s` is that of the first row, none where this is it.
double measure(LoopBench& bench, const Row& row, std::optional<double> undisturbed_s) {
  const Disturbance& disturbance = row.disturbance;
  std::vector<Played> closed;
  if (!bench.open_loop_alone) closed = play(bench, disturbance, false);
  const std::vector<Played> open = play(bench, disturbance, true);
  const std::vector<Played>& counted = bench.open_loop_alone ? open : closed;
  const Share share = share_of(reached(counted), bench.seeds);
  const double time_s = mean_time_s(counted);
  const double ratio = undisturbed_s && *undisturbed_s > 0 ? time_s / *undisturbed_s : 1;
  const bool in_time = !row.longest_ratio || ratio <= *row.longest_ratio;
  fmt::print("row {} runs {} reached {} low {:.1f} high {:.1f} ratio {:.2f} open {:.1f} goal {:g} {}\n", row.name,
             bench.seeds, reached(counted), share.low, share.high, ratio, share_of(reached(open), bench.seeds).percent,
             row.goal, bench.judge(share.percent >= row.goal && in_time));
  if (row.longest_ratio) fmt::print("    the ratio is to be {:g} at most\n", *row.longest_ratio);
  fmt::print("    published: {}\n", row.published);
  say_decisions(counted);
  if (!bench.open_loop_alone) say_how(bench, "closed loop", closed);
  say_how(bench, "open loop", open);
  const double cell_to_wall = mean(speeds(counted));
  fmt::print("    {:.1f} s to the goal, carries of {:.1f} s; {:.0f} times faster than real time, a process\n", time_s,
             mean(all(counted, &Played::carries_s)), cell_to_wall);
  std::fflush(stdout);
  return time_s;
}

void replay(const LoopBench& bench) {
  for (const Row& row : table()) {
    if (bench.only.empty() || !bench.wants(row.name)) continue;
    fmt::print("row {}, seed {}\n", row.name, *bench.replay);
    play_loop(row.disturbance, *bench.replay, bench.open_loop_alone, true);
  }
}

}  // namespace

bool LoopBench::wants(const std::string& row) const {
  return only.empty() || std::ranges::find(only, row) != only.end();
}

const char* LoopBench::judge(bool reaches) {
  ++goals;
  met += reaches ? 1 : 0;
  return reaches ? "met" : "SHORT";
}

std::vector<std::string> disturbance_row_names() {
  std::vector<std::string> names;
  for (const Row& row : table()) names.emplace_back(row.name);
  return names;
}

void disturbance_rows(LoopBench& bench) {
  const bool any = std::ranges::any_of(table(), [&](const Row& row) { return bench.wants(row.name); });
  if (!any) return;
  if (bench.replay) return replay(bench);
  // Times are compared with the row without a disturbance, which is always measured.
  std::optional<double> undisturbed_s;
  for (const Row& row : table()) {
    if (undisturbed_s && !bench.wants(row.name)) continue;
    const double time_s = measure(bench, row, undisturbed_s);
    if (!undisturbed_s) undisturbed_s = time_s;
  }
}

}  // namespace pizarra::bench
