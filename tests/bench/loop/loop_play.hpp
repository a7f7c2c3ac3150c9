#pragma once

// One run of a row: three marked cubes are to be stacked in an order, and something disturbs it. Which cubes, where
// they stand and how they are disturbed is drawn from the seed; the world judges.
//
//   const Played played = play_loop({.slip_chance = 0.15}, 7, false);

#include <string>
#include <vector>

#include "lisp/result.hpp"
#include "tests/bench/loop/retry_watch.hpp"

namespace pizarra::bench {

struct Disturbance {
  double slip_chance = 0;      // of each draw
  int slip_draws = 2;          // a carry
  double slip_within_s = 1.7;  // after the grasp: so long a carry takes
  double misplace = 0;         // of the edge
  bool moved = false;          // each object, during its grasp
  double slide_mm_s = 0;       // each object, that fast
  bool at_the_grip = false;    // it slides while the fingers close, and else rests before that
  bool removed = false;        // each object, out of the gripper while it is carried
  int cubes = 3;               // in the tower
};

struct Played {
  bool reached = false;  // said, and so in the world
  double took_s = 0;     // from the goal to its end, the cell's time
  double cell_s = 0;     // of the whole run, the teaching too
  double wall_s = 0;
  std::string end;  // how the cell saw it, for people
  std::vector<double> decisions_s = {};
  std::vector<double> kept = {};
  std::vector<double> carries_s = {};
  std::vector<double> grips_mm_s = {};  // as the fingers began to close, the fastest cube's speed
  std::vector<Retry> retries = {};      // of what slipped
};

// `told`: the story comes out on standard output.
Played play_loop(const Disturbance& disturbance, std::uint64_t seed, bool open_loop, bool told = false);

std::string played_to_text(const Played& played);
// Nothing of a run that died.
Played played_from_text(const std::string& text);

}  // namespace pizarra::bench
