#pragma once

// The controller of a Motoman arm as its High Speed Ethernet Server shows it; what it refuses it refuses with Yaskawa's
// codes.
//
//   HsesEmulator emulator(cabinet);
//   const std::string reply = co_await emulator.answer(datagram);       // empty: it says nothing
//   const Job serving = executor.spawn(serve(executor, emulator, *port));
//
// It carries out every datagram that comes, also one that it has had: the manual does not promise more. What it has and
// does is the MotomanController's.
//
// How far it is proven: with the driver of drivers/arm/motoman/ alone.

#include "drivers/arm/motoman/hses_packet.hpp"
#include "drivers/line/datagram_wire.hpp"
#include "drivers/simulation/controllers/arms/motoman_controller.hpp"

namespace pizarra::simulation {

class HsesEmulator {
 public:
  // The cabinet outlives it.
  explicit HsesEmulator(ArmCabinet& cabinet) : controller_(cabinet), cabinet_(cabinet) {}
  Task<std::string> answer(std::string datagram);

 private:
  // What a request comes to: data, or why not.
  struct Outcome {
    std::uint16_t refusal = 0;
    std::string data = {};
  };
  static Task<Outcome> at_once(Outcome outcome);
  Task<Outcome> carry_out(arm::HsesRequest request);
  Task<Outcome> status();
  Task<Outcome> position(std::uint16_t instance);
  Task<Outcome> variable(arm::HsesRequest request);
  Outcome turn(const arm::HsesRequest& request);
  Task<Outcome> move_pulses(arm::HsesRequest request);
  Task<Outcome> move_cartesian(arm::HsesRequest request);

  MotomanController controller_;
  ArmCabinet& cabinet_;
};

// Until destroyed. All three outlive it.
Task<void> serve(Executor& executor, HsesEmulator& emulator, line::DatagramWire& port);

}  // namespace pizarra::simulation
