#pragma once

// A FLIR / Directed Perception pan-tilt unit of the PTU-46 family as its serial line shows it: ASCII commands in,
// answers out, axes that take their time, limits, resets against the stops, and a power switch.
//
// Lifecycle: made with power on, calibrated, in the middle. Bytes come by receive(); what it says goes to `say`, later
// than the call. At most 4 KiB wait to be obeyed; what comes beyond that is lost, as on a line without flow control.
//
//   PtuEmulator unit(executor, *find_ptu_model("ptu46-17.5"));
//   unit.on_say([&](std::string_view bytes) { wire.write(bytes); });
//   unit.receive("PP1000 A ");           // "PP1000 *\r\n", and when it stands there "A *\r\n"
//   unit.power(false);                   // mid-move: it stands, says nothing, and forgets where it is
//
// How far it is proven: MRPT's driver for these units (CPtuDPerception) works with it where Debian's libmrpt-hwdrivers
// is installed (tests/drivers/ptu/mrpt_test.cpp), and so does ROS' flir_ptu; never compared with hardware.

#include <functional>

#include "blackboard/time/latch.hpp"
#include "drivers/simulation/controllers/ptu_commands.hpp"

namespace pizarra::simulation {

class PtuEmulator {
 public:
  PtuEmulator(Executor& executor, const PtuModel& model);

  void on_say(std::function<void(std::string_view)> say) { say_ = std::move(say); }
  void receive(std::string_view bytes);
  // Without power it stands still, says nothing and loses count; with power again it resets itself first.
  void power(bool on);
  bool powered() const { return powered_; }

  // Where the axes are now, as somebody beside the unit would measure them.
  double pan_deg();
  double tilt_deg();
  bool moving();

 private:
  static constexpr std::size_t most_waiting = 4096;
  static constexpr Duration look_again = 5ms;

  Task<void> work(bool power_up);
  Task<void> obey_one(std::string command);
  Task<void> reset(bool pan, bool tilt);
  Task<void> calibrate(PtuChannel& channel);
  Task<void> hit_stop(PtuChannel& channel, bool high);
  Task<void> watch_stop(PtuChannel& channel);
  Task<void> until_still(const PtuAxis& axis);
  Task<void> until_still();
  std::string next_command();
  void advance();
  void say(std::string_view text);
  void say_hit(const PtuChannel& channel);

  Executor& executor_;
  PtuUnit unit_;
  std::function<void(std::string_view)> say_;
  std::string waiting_;
  WaitList come_;
  Time advanced_to_;
  bool powered_ = true;
  Job working_;
  Job watching_pan_;
  Job watching_tilt_;
};

}  // namespace pizarra::simulation
