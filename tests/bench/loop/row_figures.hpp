#pragma once

// What is told of the runs of a row.
//
//   reached(runs);
//   mean(all(runs, &Played::carries_s));

#include <vector>

#include "tests/bench/loop/loop_play.hpp"

namespace pizarra::bench {

using Runs = std::vector<Played>;

int reached(const Runs& runs);
double mean(const std::vector<double>& values);
// The cell's time to the goal, of the runs that reached it.
double mean_time_s(const Runs& runs);
// How many times faster than real time a run went.
double mean_speed(const Runs& runs);
// The values of all runs, one after another.
std::vector<double> all(const Runs& runs, std::vector<double> Played::*part);

}  // namespace pizarra::bench
