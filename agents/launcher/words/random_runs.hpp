#pragma once

// Many random stories, one process a seed, all cores: how often a goal is reached although something interferes.
//
//   return run_random({.cell_file = "examples/01-blocks/cell.scm", .first_seed = 1, .seeds = 100});

#include <cstdint>
#include <string>

#include "agents/launcher/story/story_run.hpp"

namespace pizarra {

struct RandomRuns {
  std::string cell_file;
  std::uint64_t first_seed = 1;
  std::uint64_t seeds = 100;
  unsigned jobs = 0;  // 0: one a core
  bool json = false;
};

// Prints a line a seed as they end, in the order of the seeds, and a summary. The exit status: reached when no seed
// failed.
int run_random(const RandomRuns& runs);

struct RandomResult {
  enum class Kind : std::uint8_t { reached, refused, failed, unreadable };
  Kind kind = Kind::failed;  // unreadable: no cell to run in
  std::string line;          // what happened, for people
};

// One seed in this process.
RandomResult run_random_seed(const std::string& cell_file, std::uint64_t seed);

}  // namespace pizarra
