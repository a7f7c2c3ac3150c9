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
// A program is of one line, or lies between `def` and `end`; between `sec` and `end` it runs beside the one that runs,
// and does only what takes no time. It has no programs of its own: the dashboard loads and plays none.
//
// How far it is proven: with the driver of drivers/arm/universal/; public clients are named in docs/write-a-driver.md.

#include "drivers/arm/universal/rtde.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/ur_exchange.hpp"
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
  Task<UrState> state();
  // One message of RTDE and its answer; empty: none.
  Task<std::string> answer(std::string message);
  // How often the client wants to be told; none before it has started that.
  std::optional<Duration> told_every() const { return cabinet_.powered() ? exchange_.told_every() : std::nullopt; }
  std::string tell(const UrState& state) const { return exchange_.tell(state); }
  void forget_client() { exchange_ = UrExchange(); }

 private:
  static constexpr Duration look_again = 8ms;
  Task<void> carry_out(std::vector<UrStep> steps);
  Task<bool> move(std::vector<UrStep> moves);
  void set(const UrStep& step);
  std::string program_state() const;
  std::string safety(bool status) const;

  ArmCabinet& cabinet_;
  Executor& executor_;
  bool playing_ = false;
  UrExchange exchange_;
  std::map<std::string, double, std::less<>> numbers_;  // registers and inputs, by their names in the data exchange
  std::uint32_t outputs_ = 0;                           // a bit each
  UrState told_;                                        // last, for how fast it is
  Time told_at_{};
  Job program_;
};

// Each until destroyed. All outlive them.
Task<void> serve_rtde(Executor& executor, UrEmulator& emulator, line::ByteWire& port);
Task<void> serve_script(Executor& executor, UrEmulator& emulator, line::ByteWire& port);
Task<void> serve_dashboard(Executor& executor, UrEmulator& emulator, line::ByteWire& port);

}  // namespace pizarra::simulation
