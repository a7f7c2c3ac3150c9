#pragma once

// What boards that stand by cost while nothing happens to the one that leads.

#include "tests/bench/cluster/cluster_cell.hpp"
#include "tests/bench/figures.hpp"

namespace pizarra {
class RealExecutor;
}

namespace pizarra::bench {

// With none, one and two of them, in turns.
void say_standbys(Figures& figures, RealExecutor& executor, ClusterCell& cell, int count);

}  // namespace pizarra::bench
