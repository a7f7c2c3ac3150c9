#pragma once

// The controller of a Universal Robots arm by its TCP servers: its state by RTDE and at the client interfaces, which
// take programs of URScript that it carries out in time; power, mode and stored programs by the dashboard. A new
// program ends the one before.
//
//   UrEmulator emulator(cabinet, [](std::string_view name) { return program_in_a_file(name); });
//   const Job telling = executor.spawn(serve_rtde(executor, emulator, *rtde_port));       // and the others
//
// The pendant of its cabinet is local control, an alarm a protective stop. The model's five axes are the arm's without
// wrist 2, which stands at -90 degrees. Which programs it understands is told in ur_programs.hpp.
//
// How far it is proven: with the driver of drivers/arm/universal/; public clients are named in docs/write-a-driver.md.

#include "drivers/arm/universal/rtde.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/ur_dashboard.hpp"
#include "drivers/simulation/controllers/arms/ur_exchange.hpp"
#include "drivers/simulation/controllers/arms/ur_interface.hpp"

namespace pizarra::simulation {

class UrEmulator {
 public:
  // The cabinet outlives it.
  explicit UrEmulator(ArmCabinet& cabinet, UrPrograms::Stored stored = {})
      : cabinet_(cabinet), executor_(cabinet.executor()), programs_(cabinet, values_, messages_, std::move(stored)) {}

  // A line to the dashboard and its answer.
  Task<std::string> dashboard(std::string line) { return dashboard_.answer(std::move(line)); }
  // A program, as it came over a client interface, or one of the words that the interfaces take.
  void run(std::string_view program);
  // Takes the primary interface's messages about programs that were not sent yet.
  std::string take_said() { return messages_.take(); }
  bool powered() const { return cabinet_.powered(); }
  const arm::ArmModel& model() const { return cabinet_.model(); }
  std::uint64_t now_us() const { return messages_.now_us(); }
  Task<UrState> state();
  // One message of RTDE and its answer; empty: none.
  Task<std::string> answer(std::string message);
  // How often the client wants to be told; none before it has started that.
  std::optional<Duration> told_every() const { return cabinet_.powered() ? exchange_.told_every() : std::nullopt; }
  std::string tell(const UrState& state) const { return exchange_.tell(state); }
  void forget_client() { exchange_ = UrExchange(); }

 private:
  bool command(std::string_view words);
  void set_speed_slider(double fraction);

  ArmCabinet& cabinet_;
  Executor& executor_;
  UrPower power_{cabinet_};
  UrValues values_;
  UrMessages messages_{executor_};
  UrPrograms programs_;
  UrDashboard dashboard_{cabinet_, power_, programs_};
  UrExchange exchange_;
  UrState told_;  // last, for how fast it is
  Time told_at_{};
};

// Each until destroyed. All outlive them.
Task<void> serve_rtde(Executor& executor, UrEmulator& emulator, line::ByteWire& port);
enum class UrInterface : std::uint8_t { primary, secondary, real_time };
Task<void> serve_interface(Executor& executor, UrEmulator& emulator, UrInterface kind, line::ByteWire& port);
Task<void> serve_dashboard(Executor& executor, UrEmulator& emulator, line::ByteWire& port);

}  // namespace pizarra::simulation
