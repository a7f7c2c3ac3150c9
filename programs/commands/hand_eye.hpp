#pragma once

// `calibrate hand-eye`: the arm carries its mark before the camera, and what is seen of it there tells where the camera
// stands and where the mark is on the tool. It asks the robot and the eyes of a cell over its board, as any client.
//
//   HandEye hand_eye(executor, board, cell, arm, [](const std::string& line) { ... });
//   const Result<HandEyeResult> found = co_await hand_eye.run();
//   write_believed_camera(found->camera);                // for the cell's data
//
// Failures: no-pose (none is in view and within reach), mark-hidden, too-little-turning, uncertain, and those of robot
// and eyes. Each says what to do.

#include <functional>

#include "agents/coordinator/geometry/camera_pose.hpp"
#include "agents/runtime/roles.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/commands/hand_eye_poses.hpp"

namespace pizarra::programs {

struct HandEyeResult {
  forms::BelievedCamera camera;
  std::size_t poses = 0;      // that it is solved from
  double error_px = 0;        // root mean square over them
  std::size_t held_back = 0;  // poses that it was checked on:
  double checked_mm = 0;      // root mean square of how far the mark was placed from where the arm says it was
};

// The pairs as they were seen: solved from most of them, and checked on every fourth.
Result<HandEyeResult> solve_hand_eye(const forms::BelievedCamera& guess,
                                     const std::vector<coordinator::MarkPair>& pairs, std::size_t tried,
                                     const coordinator::CameraModel& model);

// As a file for a cell's (camera-pose ... (file ...)).
std::string write_believed_camera(const forms::BelievedCamera& camera);

class HandEye {
 public:
  using Tell = std::function<void(const std::string& line)>;

  // All outlive it.
  HandEye(Executor& executor, Board& board, const forms::CellDescription& cell, const arm::ArmModel& arm,
          std::size_t poses, Tell tell);
  Task<Result<HandEyeResult>> run();

 private:
  Task<Result<void>> begin();
  Task<Result<std::string>> player_of(runtime::Role role);
  Task<Result<Datum>> ask(std::string agent, Datum operation);
  Task<Result<void>> carry_to(CarriedPose pose);
  Task<Result<Eigen::Isometry3d>> tool();
  // None where the mark is not seen.
  Task<Result<std::optional<coordinator::MarkPair>>> look();
  Task<Result<Datum>> next_look();
  std::vector<CarriedPose> poses() const;

  Executor& executor_;
  const forms::CellDescription& cell_;
  const arm::ArmModel& arm_;
  const std::size_t wanted_;
  const Tell tell_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
  std::string robot_, eyes_;  // who plays these roles
  coordinator::CameraModel model_;
  std::int64_t frame_ = -1;
};

}  // namespace pizarra::programs
