#pragma once

// Many random stories, one process a seed, all cores: how often a goal is reached although something interferes.
//
//   return run_random({.cell_file = "examples/01-blocks/cell.scm", .first_seed = 1, .seeds = 100});

#include <chrono>
#include <cstdint>
#include <string>

namespace pizarra::programs {

struct RandomRuns {
  std::string cell_file;
  std::string arm = "";  // in place of the cell's, as put_arm() takes it
  std::uint64_t first_seed = 1;
  std::uint64_t seeds = 100;
  unsigned jobs = 0;  // 0: one a core
  bool json = false;
  // One that takes longer has hung, or the machine is too slow: it counts neither as reached nor as failed.
  std::chrono::seconds longest_run{180};
};

// Prints a line a seed as they end, in the order of the seeds, and a summary, also when interrupted. The exit status:
// reached when no seed failed, unavailable when one could not be brought to an end.
int run_random(const RandomRuns& runs);

}  // namespace pizarra::programs
