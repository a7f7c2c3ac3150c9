#pragma once

// How a story ended: as the cell saw it, as the world shows it, and what was expected and did not come.

#include <optional>
#include <string>
#include <vector>

#include "blackboard/time/clock.hpp"
#include "lisp/datum.hpp"
#include "lisp/result.hpp"

namespace pizarra::story {

struct DirectorReport {
  // How the cell saw it: reached, refused, cancelled, or timeout, not-taught, no-agents.
  std::string outcome;
  std::optional<Failure> refusal;  // for refused
  bool refusal_told = false;       // whether the coordinator told it as an event of the story
  std::vector<Datum> goal;         // the last one
  bool truth_holds = false;        // the judge's word on what that goal wants in the end
  // The stages before that, of those that the world did not show when the cell said so: one sentence each.
  std::vector<std::string> false_stages;
  bool possible = true;            // where it does not hold: whether any plan exists from the true state
  bool blind = false;              // a goal cube's mark was less than half visible for the last 2 s
  std::vector<std::string> unmet;  // expectations, one sentence each
  std::size_t events = 0;          // how many of the scenario's came
  Duration took{};                 // from the goal to its end, the cell's time

  // Reached and so in the world, every stage in its time.
  bool reached() const { return outcome == "reached" && truth_holds && false_stages.empty(); }
  // Refused for a reason that lies in the goal or the world, and the world bears it out: there is truly no plan, or a
  // cube of the goal could not be seen.
  bool refused_correctly() const;
};

}  // namespace pizarra::story
