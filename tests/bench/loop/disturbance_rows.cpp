// Towers of three under the disturbances of a published table, beside our own open loop.

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <optional>

#include "programs/command_line/exit_codes.hpp"
#include "programs/story/seed_pool.hpp"
#include "tests/bench/loop/hardness.hpp"
#include "tests/bench/loop/row_figures.hpp"
#include "tests/bench/loop/row_table.hpp"
#include "tests/bench/loop/rows.hpp"
#include "tests/bench/loop/share.hpp"
#include "tests/bench/measure.hpp"

namespace pizarra::bench {

namespace {

constexpr std::chrono::seconds longest_run{180};

Runs play(const LoopBench& bench, const Disturbance& disturbance, bool open_loop) {
  story::SeedPool pool({.first = bench.first_seed,
                        .seeds = static_cast<std::uint64_t>(bench.seeds),
                        .jobs = bench.jobs,
                        .longest = longest_run},
                       [&](std::uint64_t seed) { return played_to_text(play_loop(disturbance, seed, open_loop)); });
  Runs out;
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

void say_how(const LoopBench& bench, const char* loop, const Runs& runs) {
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
void say_decisions(const Runs& runs) {
  const std::vector<double> decisions = all(runs, &Played::decisions_s);
  if (decisions.empty()) {
    fmt::print("    no difference was noticed, so nothing was decided anew\n");
    return;
  }
  const double of_a_run_s = mean(decisions) * static_cast<double>(decisions.size()) / static_cast<double>(runs.size());
  fmt::print(
      "    differences noticed: {}; the plan gone on with {:.2f} s later (median), {:.2f} s (99 %), "
      "{:.1f} s in all of a run; {:.0f} % of the old plan's operations kept\n",
      decisions.size(), percentile(decisions, 0.5), percentile(decisions, 0.99), of_a_run_s,
      100 * mean(all(runs, &Played::kept)));
}

// What a slip costs till something is gripped again.
void say_retries(const Runs& runs) {
  std::vector<double> whole_s;
  std::array<std::vector<double>, Retry::parts> parts_s;
  for (const Played& run : runs) {
    for (const Retry& retry : run.retries) {
      whole_s.push_back(std::accumulate(retry.part_s.begin(), retry.part_s.end(), 0.0));
      for (std::size_t i = 0; i < Retry::parts; ++i) parts_s[i].push_back(retry.part_s[i]);
    }
  }
  if (whole_s.empty()) return;
  fmt::print("    slips made good: {}; gripped again {:.1f} s later (median), {:.1f} s (90 %), {:.1f} s (99 %)",
             whole_s.size(), percentile(whole_s, 0.5), percentile(whole_s, 0.9), percentile(whole_s, 0.99));
  for (std::size_t i = 0; i < Retry::parts; ++i) {
    fmt::print("; {} {:.1f}, {:.1f}", Retry::names[i], percentile(parts_s[i], 0.5), percentile(parts_s[i], 0.9));
  }
  fmt::print("\n");
}

// Beside the published open loop, where there is one.
void say_hardness(const Row& row, double open_percent) {
  if (!row.open_loop) return;
  const bool slips = row.disturbance.slip_chance > 0;
  const std::string draws = slips ? fmt::format("; draws a carry: {}", row.disturbance.slip_draws) : "";
  fmt::print("    our open loop {:.1f}, the published one {:.1f}: {}{}\n", open_percent, *row.open_loop,
             hardness(open_percent, *row.open_loop), draws);
}

MovingGrips grips_of(const Row& row, const Runs& runs) { return moving_grips(runs, row.disturbance.slide_mm_s / 2); }

// A row of cubes that move at the grip says nothing where they did not.
bool is_disturbed_as_said(const Row& row, const Runs& runs) {
  constexpr double least_share = 0.95;
  return !row.disturbance.at_the_grip || grips_of(row, runs).runs >= least_share * static_cast<double>(runs.size());
}

void say_grips(const Row& row, const Runs& runs) {
  if (!row.disturbance.at_the_grip) return;
  const MovingGrips moving = grips_of(row, runs);
  fmt::print("    a cube moved as the fingers began to close in {} of {} runs, at {} of {} grips, by {:.0f} mm/s\n",
             moving.runs, runs.size(), moving.grips, moving.of_grips, moving.median_mm_s);
}

struct Measured {
  Runs closed;
  Runs open;
};

void say_details(const LoopBench& bench, const Row& row, const Measured& measured) {
  const Runs& counted = bench.open_loop_alone ? measured.open : measured.closed;
  if (row.longest_ratio) fmt::print("    the ratio is to be {:g} at most\n", *row.longest_ratio);
  fmt::print("    published: {}\n", row.published);
  say_hardness(row, share_of(reached(measured.open), bench.seeds).percent);
  say_grips(row, counted);
  say_decisions(counted);
  say_retries(counted);
  say_how(bench, "closed loop", measured.closed);
  say_how(bench, "open loop", measured.open);
  fmt::print("    {:.1f} s to the goal, carries of {:.1f} s; {:.0f} times faster than real time, a process\n",
             mean_time_s(counted), mean(all(counted, &Played::carries_s)), mean_speed(counted));
  std::fflush(stdout);
}

// Answers the mean time to the goal; `undisturbed_s` is that of the first row, none where this is it.
double measure(LoopBench& bench, const Row& row, std::optional<double> undisturbed_s) {
  Measured measured;
  if (!bench.open_loop_alone) measured.closed = play(bench, row.disturbance, false);
  measured.open = play(bench, row.disturbance, true);
  const Runs& counted = bench.open_loop_alone ? measured.open : measured.closed;
  const Share share = share_of(reached(counted), bench.seeds);
  const double time_s = mean_time_s(counted);
  const double ratio = undisturbed_s && *undisturbed_s > 0 ? time_s / *undisturbed_s : 1;
  const bool in_time = !row.longest_ratio || ratio <= *row.longest_ratio;
  fmt::print("row {} runs {} reached {} low {:.1f} high {:.1f} ratio {:.2f} open {:.1f} goal {:g} {}\n", row.name,
             bench.seeds, reached(counted), share.low, share.high, ratio,
             share_of(reached(measured.open), bench.seeds).percent, row.goal,
             bench.judge(share.percent >= row.goal && in_time && is_disturbed_as_said(row, counted)));
  say_details(bench, row, measured);
  return time_s;
}

void replay(const LoopBench& bench) {
  for (const Row& row : row_table()) {
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
  for (const Row& row : row_table()) names.emplace_back(row.name);
  return names;
}

void disturbance_rows(LoopBench& bench) {
  const bool any = std::ranges::any_of(row_table(), [&](const Row& row) { return bench.wants(row.name); });
  if (!any) return;
  if (bench.replay) return replay(bench);
  // Times are compared with the row without a disturbance, which is always measured.
  std::optional<double> undisturbed_s;
  for (const Row& row : row_table()) {
    if (undisturbed_s && !bench.wants(row.name)) continue;
    const double time_s = measure(bench, row, undisturbed_s);
    if (!undisturbed_s) undisturbed_s = time_s;
  }
}

}  // namespace pizarra::bench
