#pragma once

// Tells the story what differs from the plan: the belief that holds no more, with the frame that showed it, and the
// part of the plan in hand that still serves.
//
//   Differences differences(surroundings, story);
//   co_await differences.tell(lost, "(STACK circle square)");      // the facts, and who expected them

#include <string>
#include <vector>

#include "agents/coordinator/pursue/planning.hpp"

namespace pizarra::coordinator {

class Differences {
 public:
  Differences(const Surroundings& surroundings, Story& story) : surroundings_(surroundings), story_(story) {}

  Task<void> tell(std::vector<Datum> lost, std::string expected_by);
  // The operation handed out is not the one that should follow the last one.
  Task<void> tell_unexpected(NextOperation expected, std::size_t next);
  Task<void> tell_still_serves(std::int64_t goal, NextOperation next);

 private:
  const Surroundings& surroundings_;
  Story& story_;
};

}  // namespace pizarra::coordinator
