// pizarra-bench-loop: how often a goal is reached although something interferes, beside what others have published.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <fmt/format.h>

#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "tests/bench/loop/rows.hpp"

namespace {

void explain_rows() {
  fmt::print(
      "reached counts runs; low, high, open and goal are percent, low and high by Wilson at 95 %; ratio is the mean "
      "time of\n"
      "the runs that reached their goal, to that of p=0. Published: Code-as-Monitor, arXiv 2412.04455, table 8, and "
      "what it\n"
      "compares with. What differs: another arm, marks in place of a language model's eyes, a simulated world that "
      "judges;\n"
      "two or three draws a carry in place of one a time step, so that our open loop fails about as often as theirs "
      "(the\n"
      "rows -once draw once a carry); parts of the edge in place of cm. A reaction row counts commands that come\n"
      "within 1.1 frame periods; its ratio is the 99th percentile in frame periods, and an open loop never reacts.\n");
}

// No story is told of the others.
void check_replay(const pizarra::bench::LoopBench& bench) {
  const std::vector<std::string> disturbed = pizarra::bench::disturbance_row_names();
  for (const std::string& row : bench.only) {
    if (!bench.replay || std::ranges::find(disturbed, row) != disturbed.end()) continue;
    throw CLI::ValidationError("--replay", "there is no story of " + row + ", only of the rows with a disturbance");
  }
}

}  // namespace

int main(int argc, char** argv) {
  using namespace pizarra::bench;
  CLI::App app("Towers built although cubes slip, are put down askew, moved or taken away, beside published figures.",
               "pizarra bench loop");
  LoopBench bench;
  app.add_option("--seeds,--runs", bench.seeds, "Runs a row, of either loop")
      ->check(CLI::Range(1, 100'000))
      ->capture_default_str();
  app.add_option("--first-seed", bench.first_seed, "The first of them")
      ->check(pizarra::programs::seed_check())
      ->capture_default_str();
  app.add_option("--jobs", bench.jobs, "How many at once; 0: one a core")
      ->check(CLI::Range(0, 1024))
      ->capture_default_str();
  app.add_option("--shoves", bench.shoves, "Of a reaction row, in real time: it ends after 50 s with as many as came")
      ->check(CLI::Range(1, 10'000))
      ->capture_default_str();
  std::vector<std::string> rows = disturbance_row_names();
  for (const std::string& growth : growth_row_names()) rows.push_back(growth);
  for (const std::string& reaction : reaction_row_names()) rows.push_back(reaction);
  CLI::Option* const only =
      app.add_option("--only", bench.only,
                     "These rows alone, with commas or blanks between; those with a disturbance are compared with p=0")
          ->delimiter(',')
          ->check(CLI::IsMember(rows))
          ->type_name("ROW");
  app.add_flag("--open-loop", bench.open_loop_alone, "Our open loop alone: the first plan is carried out blindly");
  CLI::Option* const replay = app.add_option("--replay", bench.replay,
                                             "Tell the story of this seed, of the rows of --only, and measure nothing")
                                  ->check(pizarra::programs::seed_check())
                                  ->needs(only);
  app.add_flag("--failures", bench.failures, "A line for every run that did not reach its goal");
  for (const char* of_rows : {"--seeds", "--first-seed", "--jobs", "--shoves", "--failures"}) replay->excludes(of_rows);
  app.footer(
      "A row of 300 runs takes some five minutes on two cores, p=0 and the open loop included; a growth row seconds; "
      "a\n"
      "reaction row a minute, whose progress is told on standard error.\n"
      "Status 0 when every row was measured, short or not; 2 for wrong arguments.");
  try {
    app.parse(argc, argv);
    check_replay(bench);
  } catch (const CLI::ParseError& error) {
    return pizarra::programs::end_of_parsing(app, error);
  }
  if (bench.replay) {
    disturbance_rows(bench);
    return 0;
  }
  explain_rows();
  disturbance_rows(bench);
  growth_rows(bench);
  reaction_rows(bench);
  fmt::print("goals met {} of {}\n", bench.met, bench.goals);
  return 0;
}
