#pragma once

// `calibrate hand-eye`: the arm carries its mark before the camera, and what is seen of it there tells where the camera
// stands and where the mark is on the tool. A camera on a pan-tilt unit is also turned at some of these poses, which
// tells about which axes it turns. It asks the robot, the eyes and the unit of a cell over its board, as any client.
//
//   HandEye hand_eye(executor, board, cell, arm, [](const std::string& line) { ... });
//   const Result<HandEyeResult> found = co_await hand_eye.run();
//   write_believed_camera(found->camera);                // for the cell's data
//
// Failures: no-pose (none is in view and within reach), those of hand_eye_solution.hpp, and those of robot, eyes and
// unit. Each says what to do.

#include <functional>

#include "agents/coordinator/geometry/camera_pose.hpp"
#include "agents/launcher/local_cell.hpp"
#include "agents/runtime/roles.hpp"
#include "lisp/forms/cell_file.hpp"
#include "programs/hand_eye/hand_eye_poses.hpp"
#include "programs/hand_eye/hand_eye_solution.hpp"
#include "programs/hand_eye/turned_head.hpp"

namespace pizarra::hand_eye {

class HandEye {
 public:
  using Tell = std::function<void(const std::string& line)>;

  // All outlive it.
  HandEye(Executor& executor, Board& board, const forms::CellDescription& cell, const arm::ArmModel& arm,
          std::size_t poses, Tell tell);
  Task<Result<HandEyeResult>> run();

 private:
  Task<Result<void>> begin();
  Task<Result<void>> begin_with_head();
  Task<Result<std::string>> player_of(runtime::Role role);
  Task<Result<Datum>> ask(std::string agent, Datum operation);
  Task<Result<void>> carry_to(CarriedPose pose);
  Task<Result<Eigen::Isometry3d>> tool();
  // At the pose that the mark was carried to.
  Task<Result<void>> look_there(std::string where, bool turning);
  Task<Result<void>> look_turned(Eigen::Isometry3d tool, std::string where);
  Task<Result<void>> look_with(ptu::HeadTurn head, SeenPairs& seen, std::string where);
  // None where the mark is not seen.
  Task<Result<std::optional<coordinator::MarkPair>>> look(ptu::HeadTurn head);
  Task<Result<Datum>> next_look();
  std::vector<CarriedPose> poses() const;
  // How far from the edge of the view a mark must be: it may be elsewhere than by the guess.
  double margin_mm() const;

  Executor& executor_;
  const forms::CellDescription& cell_;
  const arm::ArmModel& arm_;
  const std::size_t wanted_;
  const Tell tell_;
  runtime::AgentContext context_;
  runtime::Service service_;
  runtime::Caller caller_;
  std::string robot_, eyes_;        // who plays these roles
  std::optional<TurnedHead> head_;  // none where the camera stands still
  ptu::PanTiltRange head_range_{};
  coordinator::CameraModel model_;
  SeenPairs unturned_, turned_;
  std::int64_t frame_ = -1;
};

// The same in a simulated cell of this process: its agents are started, and the person teaches the eyes.
Task<Result<HandEyeResult>> find_in_local_cell(launcher::LocalCell& cell, Board& board, HandEye& hand_eye);

}  // namespace pizarra::hand_eye
