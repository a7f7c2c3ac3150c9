#pragma once

// The faults of one class, drawn. A class of one's own begins here, in fault_classes(), and in FaultPlayer.
//
//   std::vector<Fault> faults = draw_faults("network", cell, goal, 20, random);

#include <vector>

#include "blackboard/time/random.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/chaos/fault.hpp"

namespace pizarra::chaos {

std::vector<Fault> draw_faults(const std::string& kind, const forms::CellDescription& cell,
                               const std::vector<Datum>& goal, double phase_s, Random random);

}  // namespace pizarra::chaos
