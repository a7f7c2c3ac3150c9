#pragma once

// The rows with a disturbance: what disturbs, what is to be reached, and what others published.
//
//   for (const Row& row : row_table()) play_loop(row.disturbance, seed, false);

#include <optional>
#include <vector>

#include "tests/bench/loop/loop_play.hpp"

namespace pizarra::bench {

struct Row {
  const char* name;
  Disturbance disturbance;
  double goal;                           // percent
  std::optional<double> longest_ratio;   // of the time, to that without a disturbance
  const char* published;                 // percent, of the tables that are compared with
  std::optional<double> open_loop = {};  // percent, of the published one
};

// The first is the one without a disturbance.
const std::vector<Row>& row_table();

}  // namespace pizarra::bench
