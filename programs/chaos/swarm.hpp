#pragma once

// Many runs, each drawn from its seed: what became of them, how often each point of the coverage was come to, and of
// each that failed the fewest faults that still fail and the line to replay it.
//
//   const Tally tally = run_swarm({.cell = cell, .first_seed = 1, .runs = 200}, stdout);
//   fmt::print("{}\n", last_line(tally));

#include <cstdio>
#include <string>
#include <vector>

#include "lisp/forms/cell_file.hpp"
#include "programs/chaos/tally.hpp"

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

Tally run_swarm(const SwarmOptions& options, std::FILE* out);

}  // namespace pizarra::chaos
