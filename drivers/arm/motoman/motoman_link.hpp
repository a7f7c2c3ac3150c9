#pragma once

// The interface of a MotomanArm to a Motoman controller, whichever protocol reaches it: pulses, millimetres and
// switches, as the controller has them.
//
// Lifecycle: open(); the others. `no-answer` and `disconnected` leave open whether the controller has done what was
// asked. Questions and switches are repeated until they are answered; a move is sent ONCE, so that it is the arm's part
// to look whether it was begun.
//
// Failures: no-answer, disconnected, bad-reply; refused, whose subject is the controller's code (refusal_codes.hpp).
//
//   const Result<MotomanStatus> status = co_await link.status();

#include <array>
#include <cstdint>

#include "blackboard/time/clock.hpp"
#include "blackboard/time/task.hpp"
#include "lisp/result.hpp"

namespace pizarra::arm {

inline constexpr std::size_t motoman_axes = 8;
// Poses and openings go over the wire in micrometres.
inline constexpr double um_per_mm = 1000;
using MotomanPulses = std::array<std::int32_t, motoman_axes>;

struct MotomanStatus {
  bool running = false;
  bool teaching = false;  // the pendant has control
  bool remote = false;    // commands may come from outside
  bool pendant_hold = false;
  bool external_hold = false;
  bool command_hold = false;
  bool alarm = false;
  bool error = false;
  bool servo = false;
};

// Reads a controller's two status words, whichever protocol brings them.
inline MotomanStatus motoman_status(std::uint32_t modes, std::uint32_t states) {
  MotomanStatus status;
  status.running = modes >> 3 & 1;
  status.teaching = modes >> 5 & 1;
  status.remote = modes >> 7 & 1;
  status.pendant_hold = states >> 1 & 1;
  status.external_hold = states >> 2 & 1;
  status.command_hold = states >> 3 & 1;
  status.alarm = states >> 4 & 1;
  status.error = states >> 5 & 1;
  status.servo = states >> 6 & 1;
  return status;
}

// Of the controller's tool in its base frame.
struct MotomanPose {
  std::array<double, 3> place_mm{};
  std::array<double, 3> angles_deg{};  // Rx, Ry, Rz
  std::uint32_t form = 0;
  std::uint32_t extended_form = 0;
  std::uint32_t tool = 0;
};

enum class MotomanSwitch : std::uint8_t { servo, hold };

class MotomanLink {
 public:
  virtual ~MotomanLink() = default;
  virtual Task<Result<void>> open(Time deadline) = 0;
  virtual Task<Result<MotomanStatus>> status() = 0;
  virtual Task<Result<std::uint32_t>> alarm_code() = 0;
  virtual Task<Result<MotomanPulses>> pulses() = 0;
  virtual Task<Result<MotomanPose>> pose() = 0;
  virtual Task<Result<void>> turn(MotomanSwitch which, bool on) = 0;
  // Alarms and errors.
  virtual Task<Result<void>> reset() = 0;
  // `part` 0..1 of the axes' speeds.
  virtual Task<Result<void>> move_joints(MotomanPulses target, double part) = 0;
  virtual Task<Result<void>> move_straight(MotomanPose target, double mm_s) = 0;
  // Double precision integer variables, D000 to D099.
  virtual Task<Result<std::int32_t>> variable(int number) = 0;
  virtual Task<Result<void>> set_variable(int number, std::int32_t value) = 0;
  // ArmDriver's.
  virtual Duration longest_silence() const { return 150ms; }
};

}  // namespace pizarra::arm
