#pragma once

// The rows of pizarra-bench-loop.

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pizarra::bench {

struct LoopBench {
  int seeds = 300;
  std::uint64_t first_seed = 1;
  unsigned jobs = 0;
  int shoves = 100;  // of the reaction rows
  std::vector<std::string> only;
  bool open_loop_alone = false;
  bool failures = false;                // a line each
  std::optional<std::uint64_t> replay;  // the seed whose story is told, of the rows wanted
  int goals = 0;
  int met = 0;
  bool wants(const std::string& row) const;
  // "met" or "SHORT", and counts it.
  const char* judge(bool reaches);
};

// The names, for --only.
std::vector<std::string> disturbance_row_names();
void disturbance_rows(LoopBench& bench);
std::vector<std::string> growth_row_names();
void growth_rows(const LoopBench& bench);
std::vector<std::string> reaction_row_names();
void reaction_rows(LoopBench& bench);

}  // namespace pizarra::bench
