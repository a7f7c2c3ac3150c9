#pragma once

// Many runs, each drawn from its seed: what became of them, how often each point of the coverage was come to, and of
// each that failed the fewest faults that still fail and the line to replay it.
//
//   const Tally tally = run_swarm({.cell = cell, .first_seed = 1, .runs = 200}, stdout);
//   fmt::print("{}\n", last_line(tally));

#include <cstdio>
#include <string>
#include <vector>

#include "programs/chaos/chaos_run.hpp"

namespace pizarra::chaos {

struct SwarmOptions {
  forms::CellDescription cell;
  std::uint64_t first_seed = 1;
  std::uint64_t runs = 100;
  unsigned jobs = 0;
  std::vector<std::string> only = {};  // classes of faults
  bool shrink = true;
  bool stop_at_failure = false;
  std::string plant = {};
  std::string replay_with = {};  // what a line to replay a run says beside the seed
};

struct Tally {
  std::uint64_t runs = 0;
  std::uint64_t reached = 0;
  std::uint64_t refused = 0;
  std::uint64_t failed = 0;
  std::uint64_t unsafe = 0;
  std::uint64_t hung = 0;
  double cell_s = 0;
  double cpu_s = 0;
  Coverage coverage;
  bool whole = true;  // no run is missing
};

Tally run_swarm(const SwarmOptions& options, std::FILE* out);

// "chaos runs N reached R refused C failed F unsafe U hung H unreached P"
std::string last_line(const Tally& tally);
bool passes(const Tally& tally);

struct PlantSearch {
  std::uint64_t found_by = 0;  // so many runs; 0: none found it
  bool whole = true;           // not interrupted
};
// Runs until one fails that does not fail without the planted fault.
PlantSearch find_plant(const SwarmOptions& options);

// The fewest faults of the story that fail as it does, by leaving out one half after another, then one after another.
// Plays some tens of runs at most.
std::vector<std::size_t> shrink(const ChaosStory& story, const std::string& plant = {});

}  // namespace pizarra::chaos
