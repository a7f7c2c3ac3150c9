#pragma once

// The figures of `bench arms`, one function and file each; main.cpp lists them.

#include <cstdint>

#include "tests/bench/figures.hpp"

namespace pizarra::bench {

struct ArmsBench {
  Figures& figures;
  std::uint64_t targets;  // of every arm, reachable and unreachable ones each
  std::uint64_t stops;    // how often an arm in motion is stopped, and one at rest commanded
  std::uint64_t moves;    // over a bad network
};

void one_move(ArmsBench& bench);
void state_stream(ArmsBench& bench);
void random_targets(ArmsBench& bench);
void lines_of_description(ArmsBench& bench);
void stop_latency(ArmsBench& bench);
void bad_network(ArmsBench& bench);
void command_latency(ArmsBench& bench);

}  // namespace pizarra::bench
