#pragma once

// A job of a Motoman controller as its file has it: how long it takes, line by line. Understood are NOP, END, comments
// and TIMER; a job with other instructions is not begun.
//
//   const Result<std::vector<Duration>> lines = read_motoman_job(text);      // what each instruction waits

#include <string_view>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/result.hpp"

namespace pizarra::simulation {

// Failure: bad-job, the line's number among the instructions as its subject.
Result<std::vector<Duration>> read_motoman_job(std::string_view text);

}  // namespace pizarra::simulation
