#pragma once

// The coordinator's perception of its cell: it makes of every look of the eyes where things stand (Scene) and which of
// the domain's predicates hold (Beliefs), and has the latter told (BeliefTeller). The facts of the
// devices come to the same scene (DeviceFacts). Nothing here acts.
//
// Lifecycle: start() and follow_...() spawn the watches, which go on until it is destroyed or others are followed.
//
//   surroundings.start();
//   surroundings.follow_eyes("vision-2");
//   bool seen = co_await surroundings.look_after(surroundings.looks() + 1, deadline);   // a look that began since
//   surroundings.beliefs();                                                             // {(on circle triangle), ...}

#include <set>
#include <string>

#include "agents/coordinator/perceive/belief_teller.hpp"
#include "agents/coordinator/perceive/camera_pose_news.hpp"
#include "agents/coordinator/perceive/capture_clock.hpp"
#include "agents/coordinator/perceive/device_facts.hpp"
#include "agents/coordinator/story.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::coordinator {

class Surroundings {
 public:
  // Everything outlives it. Facts it tells stand under the service's presence, so that they go with the coordinator.
  Surroundings(runtime::AgentContext& context, const CoordinatorOptions& options, const TaskDomain& domain,
               const runtime::Service& service, Story& story);

  // The camera's pose that an earlier life had measured.
  Task<void> resume();
  void start();
  // Follows the facts of these agents from now on: they play the roles.
  void follow_eyes(const std::string& agent);
  void follow_robot(const std::string& agent) { devices_.follow_robot(agent); }

  const Scene& scene() const { return scene_; }
  const Facts& beliefs() const { return beliefs_.facts(); }
  std::uint64_t looks() const { return scene_.sightings().looks(); }
  // What the newest look tells of, seen or not.
  const std::set<std::string>& tracked() const { return tracked_; }
  // The look in which a belief came or went last.
  Beliefs::Evidence changed_in(const Datum& belief) const { return beliefs_.changed_in(belief); }
  // Whether the scene is calm, what is perceived is believed, and all these objects lie still in sight.
  bool steady(const std::vector<std::string>& objects) const {
    return beliefs_.settled() && scene_.calm() && scene_.still(objects);
  }

  // Whether the newest look has just come, and its frame is known to have been captured while the arm rested as it
  // does. A look to come would show no more.
  bool shows_rest() const;

  // What is hidden no longer counts as there.
  void doubt_hidden() { scene_.doubt_hidden(); }
  // The gripper's mark is not seen where it should be in view: the camera may have been moved.
  void doubt_camera() { scene_.doubt_camera(); }

  // True once more than `look` looks were made, false at the deadline.
  Task<bool> look_after(std::uint64_t look, Time deadline);
  // The same of the second: the first may have been under way.
  Task<bool> second_look_after(std::uint64_t look, Time deadline) { return look_after(look + 1, deadline); }
  // The same of the first, where its frame is known to have been captured while the arm rested as it does; else of the
  // second.
  Task<bool> look_at_rest_after(std::uint64_t look, Time deadline);

 private:
  bool captured_at_rest() const;
  Task<void> take_look(Change change);
  Task<void> tell_failure(Failure why);

  runtime::AgentContext& context_;
  const TaskDomain& domain_;
  Story& story_;

  Scene scene_;
  DeviceFacts devices_;
  Beliefs beliefs_;
  BeliefTeller belief_teller_;
  CameraPoseNews camera_pose_news_;
  std::set<std::string> tracked_;
  CaptureClock capture_clock_;
  std::optional<Time> captured_;  // on the board's clock; none where it is not known
  Time came_at_;                  // the newest look, on this agent's clock
  std::string told_failure_;
  WaitList looked_;
  Job eyes_;
};

}  // namespace pizarra::coordinator
