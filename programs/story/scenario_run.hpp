#pragma once

// A scenario from beginning to end in a cell of this process, in virtual time or in this machine's.
//
//   Narrator narrator(stdout, Narrator::Style::plain);
//   Result<StoryReport> report = run_story(scenario, cell, {.seed = 7}, narrator);
//   if (report && report->director.reached()) ...

#include <functional>
#include <string>

#include "blackboard/time/stop_signals.hpp"
#include "programs/story/director.hpp"
#include "programs/story/narrator.hpp"

namespace pizarra::story {

struct StoryOptions {
  std::uint64_t seed = 1;
  bool realtime = false;
  std::string journal_file;  // empty: none
  std::string film_file;     // empty: none
  std::string picture_file;  // empty: none
  // Ends the story before its end when a signal has come; none: nothing does. Outlives the run.
  const StopSignals* stop = nullptr;
  DirectorOptions director = {};
  // A task that runs beside the story until that ends, for instance to measure. Empty: none.
  std::function<Task<void>(launcher::LocalCell& cell)> beside = {};
};

struct StoryReport {
  DirectorReport director;
  Duration simulated{};  // the cell's time, all of it
  double wall_s = 0;
  bool interrupted = false;  // by a signal: what was recorded until then is whole, and nothing is judged
  // How many times faster than real time it went.
  double speed() const { return wall_s > 0 ? static_cast<double>(simulated.count()) / 1e6 / wall_s : 0; }
};

// The cell file with the scenario's cubes and domain in place of its own.
Result<forms::CellDescription> cell_of(const forms::Scenario& scenario);
// The cell's domain as its coordinator reads it, so that what that would refuse is told before anything begins.
Result<forms::Domain> domain_of(const forms::CellDescription& cell);
// Whether one of its agents reads it.
bool needs_domain(const forms::CellDescription& cell);

// Whether its conditions and expectations are queries. Failure: bad-scenario.
Result<void> check_scenario(const forms::Scenario& scenario);

// Failures: bad-cell, bad-scenario, cannot-write; how the story ended is the report's.
Result<StoryReport> run_story(const forms::Scenario& scenario, const forms::CellDescription& cell,
                              const StoryOptions& options, Narrator& narrator);

}  // namespace pizarra::story
