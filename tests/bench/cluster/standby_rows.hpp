#pragma once

// The cost of boards that stand by, while the one that leads goes on leading.

#include "tests/bench/cluster/cluster_cell.hpp"
#include "tests/bench/figures.hpp"

namespace pizarra {
class RealExecutor;
}

namespace pizarra::bench {

// With none, one and two of them, in turns.
void say_standbys(Figures& figures, RealExecutor& executor, ClusterCell& cell, int count);

}  // namespace pizarra::bench
