#pragma once

// A Motoman controller that runs MotoROS: trajectories at one port, state and joints of its control group at the other
// every 25 ms.
//
//   MotorosEmulator emulator(executor, cabinet);
//   const Job moving = executor.spawn(serve_motion(executor, emulator, *motion_line));
//   const Job telling = executor.spawn(serve_state(executor, emulator, *state_line));
//
// It refuses with the published server's results and subcodes: a trajectory that does not begin where the arm stands, a
// point that lacks something, is too fast or beyond the limits, one that comes while it is not in trajectory mode; and
// is busy once it holds many. The points that have come within a moment are one way for the arm, which takes as long as
// their times say; it has ramps of its own, where the published server follows the points' own speeds, and stands
// between one such way and the next.
//
// How far it is proven: with the driver of drivers/arm/simple_message/ alone.

#include <deque>

#include "drivers/arm/simple_message/motoros_message.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/serve_frames.hpp"

namespace pizarra::simulation {

class MotorosEmulator {
 public:
  // Both outlive it.
  MotorosEmulator(Executor& executor, ArmCabinet& cabinet, line::ByteOrder order = line::ByteOrder::little)
      : executor_(executor), cabinet_(cabinet), order_(order) {}
  static constexpr Duration told_every = 25ms;  // its state
  line::FrameReader frames() const;
  bool powered() const { return cabinet_.powered(); }
  // A message without its frame, and the reply with one; empty: none.
  Task<std::string> answer(std::string message);
  // Joints and status, each with its frame.
  Task<std::string> state();

 private:
  static constexpr Duration gathering_time = 60ms;
  static constexpr Duration look_again = 8ms;
  static constexpr std::size_t most_points = 400;

  std::string framed(const arm::SimpleMessage& message) const;
  Task<arm::MotorosReply> obey(arm::MotorosControl control);
  Task<arm::MotorosReply> take(arm::MotorosPoint point);
  std::int32_t fault_of(const arm::MotorosPoint& point, const arm::Joints& joints) const;
  std::int32_t why_not_ready() const;
  arm::Joints joints_of(const arm::SimpleJoints& joints, const arm::Joints& stands) const;
  Task<void> follow();

  struct Place {
    double time_s;
    arm::Joints joints;
  };
  Executor& executor_;
  ArmCabinet& cabinet_;
  line::ByteOrder order_;
  bool in_trajectory_mode_ = false;
  std::int32_t next_ = 0;
  Place last_{};  // of the trajectory, so far
  std::deque<Place> waiting_;
  bool following_ = false;
  Job job_;
};

}  // namespace pizarra::simulation
