#pragma once

// FLIR / Directed Perception pan-tilt units (PTU-46-17.5, PTU-46-70 and their kin) by their ASCII commands, over a
// serial line (9600 baud) or TCP (port 4000 of those with Ethernet).
//
//   TcpWire wire(executor, "192.168.0.2", 4000);
//   PtuDriver unit(executor, wire);
//   const Result<PanTiltRange> range = co_await unit.connect();
//
// Resolution, limits and speeds are asked, never assumed. The unit is made to echo its commands, so that an answer is
// known by its command, and one that comes late is not taken for another's; a unit that does not echo is taken at its
// word, answer after answer. (There is no checksum: a digit that vanishes on the line is not noticed.) One command is
// under way at a time, the others wait.
//
// How far it is proven: with the emulator of drivers/simulation/controllers/ over a pseudo-terminal, TCP and lines that
// lose and garble; never with hardware. Which way a unit counts is not in the sources: where pan counts to the left or
// tilt counts downwards, say so in PtuDirections.

#include "blackboard/time/turns.hpp"
#include "drivers/line/frames.hpp"
#include "drivers/ptu/pan_tilt_driver.hpp"
#include "drivers/ptu/ptu_reply.hpp"

namespace pizarra::ptu {

struct PtuDirections {
  bool pan_reversed = false;
  bool tilt_reversed = false;
};

class PtuDriver : public PanTiltDriver {
 public:
  // The wire outlives it.
  PtuDriver(Executor& executor, line::ByteWire& wire, PtuDirections directions = {});

  Task<Result<PanTiltRange>> connect() override;
  void close() override;
  Task<Result<void>> move_to(PanTiltAxis axis, double deg) override;
  Task<Result<void>> set_speed(PanTiltAxis axis, double part) override;
  Task<Result<void>> halt() override;
  Task<Result<void>> reset(PanTiltAxis axis) override;
  Task<Result<void>> reset_all() override;
  Task<Result<PanTiltReading>> read() override;

 private:
  static constexpr Duration answer_time = 1s;
  static constexpr Duration opening_time = 3s;
  static constexpr Duration reset_time = 90s;  // a slow unit crosses its whole range four times
  static constexpr Duration quiet_time = 100ms;
  static constexpr Duration longest_noise = 2s;

  // As the unit counts.
  struct Axis {
    char letter;
    std::string_view name;
    double way;  // 1, or -1 where it counts the other way round
    double deg_per_count = 0;
    double low = 0;
    double high = 0;
    double slowest = 0;
    double fastest = 0;
  };

  Axis& axis_of(PanTiltAxis axis) { return axis == PanTiltAxis::pan ? pan_ : tilt_; }
  Task<Result<PanTiltRange>> connect_in_turn();
  Task<Result<void>> quieten();
  Task<Result<void>> set_up();
  Task<Result<void>> ask_axis(Axis& axis);
  PanTiltAxisRange range_of(const Axis& axis) const;

  Task<Result<std::string>> exchange(std::string command, Duration patience);
  Task<Result<std::string>> answer_to(std::string command, Duration patience);
  Task<Result<double>> ask(Axis& axis, char what);
  Task<Result<void>> command(std::string command, Duration patience);
  std::unexpected<Failure> lose(Failure why);
  std::unexpected<Failure> not_understood(std::string_view command, std::string_view said) const;

  Executor& executor_;
  line::ByteWire& wire_;
  const std::string device_;
  line::Frames lines_;
  Axis pan_;
  Axis tilt_;
  bool connected_ = false;
  std::string why_lost_;
  bool echoes_ = false;
  Turns turns_;  // commands are carried out one after another
};

}  // namespace pizarra::ptu
