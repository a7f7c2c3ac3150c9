#pragma once

// What is told of the runs of a row.
//
//   const MovingGrips moving = moving_grips(runs, 25);
//   moving.runs;                       // in so many of them a cube moved that fast as the fingers began to close

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

// Grips at which a cube still moved as the fingers began to close.
struct MovingGrips {
  int grips = 0;
  int of_grips = 0;
  int runs = 0;  // with at least one
  double median_mm_s = 0;
};
MovingGrips moving_grips(const Runs& runs, double least_mm_s);

}  // namespace pizarra::bench
