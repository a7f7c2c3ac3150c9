#pragma once

// The DETAIL of a running goal's state, (goal-state N running DETAIL): the objects that are waited for, and the stage
// that a new life goes on with.
//
//   told_in_stage(0, told_missing({"circle"}));      // (missing circle)
//   told_in_stage(1, Datum());                       // (stage 2)
//   stage_told(read("(stage 2)"));                   // 1

#include <cstddef>
#include <string>
#include <vector>

#include "lisp/datum.hpp"

namespace pizarra::coordinator {

Datum told_missing(const std::vector<std::string>& names);
// The state names the stage from the second one on. `detail`: what else it tells; () is nothing.
Datum told_in_stage(std::size_t stage, const Datum& detail);
// 0 where none is named.
std::size_t stage_told(const Datum& detail);

}  // namespace pizarra::coordinator
