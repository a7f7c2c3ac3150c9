#pragma once

// Brings into view what an operation is to work with: what another object covers, and what the images cut off.
//
//   RoomToSee room(surroundings, search, rescues);
//   room.begin();                                               // a goal
//   Result<bool> changed = co_await room.make(goal, next);      // what comes of it is seen afterwards
//   if (changed && !*changed) ...                               // the operation can be tried

#include <map>
#include <optional>
#include <string>

#include "agents/coordinator/pursue/object_search.hpp"

namespace pizarra::coordinator {

class RoomToSee {
 public:
  RoomToSee(const Surroundings& surroundings, ObjectSearch& search, Rescues& rescues)
      : surroundings_(surroundings), search_(search), rescues_(rescues) {}

  // Forgets the goal before.
  void begin() { carries_to_cut_off_.clear(); }
  // Whether there was something to try. Where there was nothing, the operation can be tried as it is. Failures:
  // hold-ups, interrupted and camera-doubtful, as those of the search.
  Task<Result<bool>> make(std::int64_t goal, NextOperation next);
  // After a difference: the object on which the operation puts the one in hand, if the images cut it off.
  Task<void> make_below_carried(GroundOperation operation);

 private:
  std::optional<std::string> cut_off_below_carried(const GroundOperation& operation) const;
  // Sets aside what stands before the object that the operation is to grasp, or to put something on.
  Task<Result<bool>> uncover(std::int64_t goal, NextOperation next);

  const Surroundings& surroundings_;
  ObjectSearch& search_;
  Rescues& rescues_;
  std::map<std::string, int> carries_to_cut_off_;  // to each object that the images cut off
};

}  // namespace pizarra::coordinator
