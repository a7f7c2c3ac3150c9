#pragma once

// The controller of a Universal Robots arm by its three TCP servers: its state by RTDE, programs of URScript that it
// carries out in time, power and mode by the dashboard. A new program ends the one before.
//
//   UrEmulator emulator(cabinet);
//   const Job telling = executor.spawn(serve_rtde(executor, emulator, *rtde_port));       // and the other two
//
// The pendant of its cabinet is local control, an alarm a protective stop. The model's five axes are the arm's without
// wrist 2, which stands at -90 degrees. What it does not understand of a program or a message it leaves out, as the
// controller does but for a line in its log.
//
// How far it is proven: with the driver of drivers/arm/universal/ alone.

#include <map>

#include "drivers/arm/universal/rtde.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/urscript.hpp"

namespace pizarra::simulation {

class UrEmulator {
 public:
  // The cabinet outlives it.
  explicit UrEmulator(ArmCabinet& cabinet) : cabinet_(cabinet), executor_(cabinet.executor()) {}

  // A line to the dashboard and its answer.
  Task<std::string> dashboard(std::string line);
  // A program, as it came over the script port.
  void run(std::string_view program);
  Task<arm::rtde::State> state();
  // One message of RTDE and its answer; empty: none.
  Task<std::string> answer(std::string message);
  // How often the client wants to be told; none before it has started that.
  std::optional<Duration> told_every() const {
    return telling_ && cabinet_.powered() ? std::optional(period_) : std::nullopt;
  }
  void forget_client() { telling_ = false; }

 private:
  static constexpr Duration look_again = 8ms;
  Task<void> carry_out(std::vector<UrStep> steps);
  Task<bool> move(std::vector<UrStep> moves);
  std::string accept(char type, line::OctetReader& read);

  ArmCabinet& cabinet_;
  Executor& executor_;
  bool playing_ = false;
  bool telling_ = false;
  Duration period_ = 8ms;
  std::map<int, std::int32_t> registers_;
  Job program_;
};

// Each until destroyed. All outlive them.
Task<void> serve_rtde(Executor& executor, UrEmulator& emulator, line::ByteWire& port);
Task<void> serve_script(Executor& executor, UrEmulator& emulator, line::ByteWire& port);
Task<void> serve_dashboard(Executor& executor, UrEmulator& emulator, line::ByteWire& port);

}  // namespace pizarra::simulation
