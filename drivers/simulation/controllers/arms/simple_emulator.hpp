#pragma once

// A controller that speaks ROS-Industrial's simple_message: points of a trajectory one at a time, in the order of their
// numbers, and its state every 20 ms. As the CRS C500C with the servers of crs-c500c-utils, whose angles count the
// other way round and which moves at a fifth of its speed, whatever it is told.
//
//   SimpleEmulator emulator(cabinet, {.serial = true, .sign = -1, .fixed_speed = 0.2});
//   const Job moving = executor.spawn(serve_motion(executor, emulator, *motion_line));
//   const Job telling = executor.spawn(serve_state(executor, emulator, *state_line));
//
// A point out of order stops the arm; one that comes while the arm moves is refused. Its servos are switched on by
// hand, as its power comes on.
//
// How far it is proven: with the driver of drivers/arm/simple_message/, and by the published server's answers, message
// by message (docs/write-a-driver.md).

#include "drivers/arm/simple_message/simple_message.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/serve_frames.hpp"

namespace pizarra::simulation {

struct SimpleKind {
  bool serial = false;  // frames of a serial line, or of TCP
  line::ByteOrder order = line::ByteOrder::little;
  double sign = 1;
  bool track = false;      // it has the track among its joints
  double fixed_speed = 0;  // part of the axes' speeds, whatever a point says; 0: as the point says
};

class SimpleEmulator {
 public:
  // The cabinet outlives it.
  SimpleEmulator(ArmCabinet& cabinet, SimpleKind kind) : cabinet_(cabinet), kind_(kind) {
    static_cast<void>(cabinet_.servo(true));
  }
  static constexpr Duration told_every = 20ms;  // its state
  line::FrameReader frames() const;
  bool powered() const { return cabinet_.powered(); }
  // A message without its frame, and the reply with one; empty: none.
  Task<std::string> answer(std::string message);
  // Position and status, each with its frame.
  Task<std::string> state();

 private:
  std::string framed(const arm::SimpleMessage& message) const;
  Task<bool> obey(arm::SimplePoint point);

  ArmCabinet& cabinet_;
  SimpleKind kind_;
  std::int32_t last_sequence_ = -1;
};

}  // namespace pizarra::simulation
