#pragma once

// The agent's hold on one pan-tilt unit: connects to it, and again whenever it was lost, moves it, and sees to it that
// the board knows where the head looks, or that nobody knows.
//
// Lifecycle: run() goes on for as long as it lives.
//
//   const Job job = executor.spawn(head.run());
//   const Result<void> moving = co_await head.move({.pan_deg = 10, .tilt_deg = {}});   // accepted, not yet there
//
// Before a move begins the board has been told that the head moves, and it is told that it stands only once it does:
// what a camera sees in between is of no known direction.
//
// Failures: closed, disconnected (with the reason), out-of-range, and the driver's.

#include <optional>

#include "agents/pan_tilt/head_facts.hpp"
#include "blackboard/time/latch.hpp"

namespace pizarra::pan_tilt {

struct HeadMove {
  std::optional<double> pan_deg;
  std::optional<double> tilt_deg;
};

struct HeadSpeeds {
  double pan_percent = 20;
  double tilt_percent = 20;
};

class HeadControl {
 public:
  static constexpr Duration poll_moving = 50ms;
  static constexpr Duration poll_still = 200ms;
  static constexpr Duration reconnect_pause = 1s;

  HeadControl(runtime::AgentContext& context, ptu::PanTiltDriver& driver, HeadFacts& facts)
      : context_(context), driver_(driver), facts_(facts), changed_(context.executor) {}

  Task<void> run();
  // Wanted open, it connects; closed, it lets the unit alone.
  Task<Result<void>> open(Time deadline);
  Task<Result<void>> close();

  Task<Result<void>> move(HeadMove move);
  // To the nearest it can.
  HeadMove within_range(HeadMove move) const;
  Task<Result<void>> set_speeds(HeadSpeeds speeds);
  // One axis, or both where none is given.
  Task<Result<void>> reset(std::optional<ptu::PanTiltAxis> axis);
  // As the unit says now.
  Task<Result<ptu::PanTiltReading>> read();
  // True once it stands, or is lost; false at the deadline.
  Task<bool> until_still(Time deadline);

  const HeadSpeeds& speeds() const { return speeds_; }
  void begin_with(HeadSpeeds speeds) { speeds_ = speeds; }

 private:
  enum class State : std::uint8_t { closed, connecting, ready };
  class Moving;

  Task<Result<void>> connect();
  Task<Result<void>> apply_speeds();
  Task<void> watch();
  Task<void> lose(Failure why);
  Task<void> tell();
  Result<void> usable() const;
  Result<void> check(const HeadMove& move) const;

  runtime::AgentContext& context_;
  ptu::PanTiltDriver& driver_;
  HeadFacts& facts_;
  State state_ = State::connecting;
  bool wanted_ = true;
  int under_way_ = 0;  // commands that have not been answered, and may make it move
  bool moving_ = true;
  std::string trouble_ = "not connected yet";
  ptu::PanTiltRange range_{};
  ptu::PanTiltReading reading_{};
  HeadSpeeds speeds_;
  WaitList changed_;
};

}  // namespace pizarra::pan_tilt
