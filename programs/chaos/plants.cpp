#include "programs/chaos/plants.hpp"

#include <algorithm>

namespace pizarra::chaos {

const std::vector<Plant>& plants() {
  static const std::vector<Plant> all = {
      {"plan-not-kept", "the planner does not persist its plan"},
      {"goal-not-kept", "the coordinator does not persist the goal"},
      {"motion-not-kept", "the robot agent does not persist the motion that it begins"},
      {"stop-unheard", "the robot agent does not hear of stops"},
      {"commander-unheard", "the robot agent does not hear who commands its arm"},
      {"commander-heard-at-rest", "the robot agent hears who commands its arm once its motion has ended"},
      {"reached-too-soon", "a goal is said to be reached after the first operation"},
      {"refused-for-nothing", "a goal that is reached is said to be refused"},
      {"reached-for-refused", "a goal that is refused is said to be reached"},
      {"looks-old", "the coordinator takes looks of a second ago for new ones"},
      {"places-kept", "the coordinator tells of each object where it was seen first, and no more"},
      {"beliefs-kept", "the coordinator takes back nothing that it believed"},
      {"presence-for-ever", "the eyes' presence does not go with them"},
      {"lease-not-renewed", "the planner does not renew its lease"},
      {"requests-lost", "the robot agent drops one request in twenty"},
      {"replies-lost", "the eyes drop one reply in ten"},
      {"always-holds", "the robot agent tells that the gripper holds something"},
      {"one-unseen", "the eyes never see the triangle"},
      {"disk-lies", "the disk says that it flushed and did not"},
      {"journal-gone", "each life of the board begins with an empty journal"},
      {"frames-overtake", "the frames of a connection overtake each other"},
      {"stop-swallowed", "the arm's controller takes no stop"},
      {"stop-swallowed-in-state-3", "the arm's controller takes no stop while the servo is in state 3"},
      {"fingers-not-held", "the fingers cannot be told to stand after a stop"},
      {"silence-ignored", "the arm's controller moves on where it hears nothing"},
      {"motion-repeated", "the arm's controller does each motion twice"},
      {"stop-heeded-late", "the arm's controller heeds a stop 100 ms after it came"},
      {"arrives-at-once", "the arm's controller says at once that a motion has ended"},
      {"images-old", "the camera shows what it saw two seconds ago"},
      {"eyes-crossed", "the left and the right image are exchanged"},
      {"not-restarted", "nobody starts the planner again"},
  };
  return all;
}

bool is_plant(const std::string& name) {
  return std::ranges::any_of(plants(), [&](const Plant& plant) { return name == plant.name; });
}

}  // namespace pizarra::chaos
