#pragma once

// One random story from its seed to what became of it, in this process.
//
//   const RandomResult result = run_random_seed("examples/01-blocks/cell.scm", "", 7);
//   fmt::print("{}\n", result.line);

#include <cstdint>
#include <string>

namespace pizarra::story {

struct RandomResult {
  enum class Kind : std::uint8_t { reached, refused, failed, timed_out, unreadable };
  Kind kind = Kind::failed;  // timed_out: as whoever waits for it finds; unreadable: no cell to run in
  std::string line;          // what happened, for people
};

// `arm` in place of the cell's, as put_arm() takes it; empty: the cell's.
RandomResult run_random_seed(const std::string& cell_file, const std::string& arm, std::uint64_t seed);

}  // namespace pizarra::story
