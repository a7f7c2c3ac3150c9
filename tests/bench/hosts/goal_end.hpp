#pragma once

// How a goal of a round ended, by what the world shows.
//
//   verdict_of({.status = 0, .world_has_it = true})        // reached

#include "programs/command_line/exit_codes.hpp"

namespace pizarra::bench {

struct GoalEnd {
  int status = 0;  // of `goal`
  bool world_has_it = false;
  bool cube_is_gone = false;           // one of the goal's
  bool nobody_would_pursue = false;    // as the refusal says
  bool lost_the_coordinator = false;   // the host that lost its power is the coordinator's
  bool ended_before_the_loss = false;  // so it is not that loss that it speaks of
};

enum class GoalVerdict { reached, refused_correctly, failed };

// A goal that came while the coordinator's host had no power is not taken, and that is said.
constexpr GoalVerdict verdict_of(const GoalEnd& end) {
  if (end.status == programs::exit_reached && end.world_has_it) return GoalVerdict::reached;
  if (end.status == programs::exit_refused && end.cube_is_gone) return GoalVerdict::refused_correctly;
  const bool by_the_loss = end.lost_the_coordinator && !end.ended_before_the_loss;
  return by_the_loss && end.nobody_would_pursue ? GoalVerdict::refused_correctly : GoalVerdict::failed;
}

}  // namespace pizarra::bench
