#pragma once

// What became of many runs, counted.
//
//   Tally tally;
//   tally.count(result);                           // each run
//   fmt::print("{}\n", last_line(tally));
//   return passes(tally) ? 0 : 1;

#include <cstdint>
#include <string>

#include "programs/chaos/chaos_run.hpp"

namespace pizarra::chaos {

struct Tally {
  void count(const RunResult& result);

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

// "chaos runs N reached R refused C failed F unsafe U hung H unreached P"
std::string last_line(const Tally& tally);
// No run was unsafe, and at most one in a hundred failed.
bool passes(const Tally& tally);

}  // namespace pizarra::chaos
