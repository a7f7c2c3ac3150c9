#pragma once

// How long a board takes to have all that a log says.

#include <cstdint>

#include "tests/bench/cluster/cluster_cell.hpp"
#include "tests/bench/figures.hpp"

namespace pizarra::bench {

// From a log of so many entries, and from its snapshot.
void say_recovery(Figures& figures, const ClusterCell& cell, std::uint64_t entries);

}  // namespace pizarra::bench
