#pragma once

// Hands on to the scene what the cell's devices tell of themselves: the camera its model, its head how far it is
// turned, the robot where it is and how far its gripper is open.
//
// Lifecycle: start() and follow_...() spawn the watches, which go on until it is destroyed or others are followed.
//
//   DeviceFacts devices(context, options, scene);
//   devices.start();
//   devices.follow_camera("vision-2");
//   devices.rests_since();                       // of the arm

#include "agents/coordinator/perceive/scene.hpp"
#include "agents/runtime/agent.hpp"

namespace pizarra::coordinator {

class DeviceFacts {
 public:
  // All outlive it.
  DeviceFacts(runtime::AgentContext& context, const CoordinatorOptions& options, Scene& scene)
      : context_(context), options_(options), scene_(scene) {}

  void start();
  // Follows these agents from now on: the eyes, whose camera it is, and the robot. Other eyes may have another camera.
  void follow_camera(const std::string& eyes);
  void follow_robot(const std::string& robot);

  // On the board's clock; none where it is not known, as while the arm moves.
  const std::optional<Time>& rests_since() const { return rests_since_; }

 private:
  using Take = void (DeviceFacts::*)(const Change&);
  Job followed(Datum pattern, Take take);
  Task<void> hand_on(Take take, Change change);
  void take_model(const Change& change);
  void take_head(const Change& change);
  void take_gripper(const Change& change);
  void take_pose(const Change& change);
  void take_foot(const Change& change);
  void take_arm(const Change& change);

  runtime::AgentContext& context_;
  const CoordinatorOptions& options_;
  Scene& scene_;
  std::optional<Time> rests_since_;
  Job head_, camera_;
  std::vector<Job> robot_;
};

}  // namespace pizarra::coordinator
