#pragma once

// The controller of a Universal Robots arm by its TCP servers: its state by RTDE and at the client interfaces, which
// take programs of URScript that it carries out in time; power, mode and stored programs by the dashboard. A new
// program ends the one before.
//
//   UrEmulator emulator(cabinet, [](std::string_view name) { return program_in_a_file(name); });
//   const Job telling = executor.spawn(serve_rtde(executor, emulator, *rtde_port));       // and the others
//
// The pendant of its cabinet is local control, an alarm a protective stop. The model's five axes are the arm's without
// wrist 2, which stands at -90 degrees. A program that it does not understand is not begun, and the
// primary interface says so.
//
// A program is of one line, or lies between `def` and `end`; between `sec` and `end` it runs beside the one that runs,
// and does only what takes no time. URScript's variables, branches, loops and threads are not understood.
//
// How far it is proven: with the driver of drivers/arm/universal/; public clients are named in docs/write-a-driver.md.

#include <deque>
#include <functional>

#include "drivers/arm/universal/rtde.hpp"
#include "drivers/simulation/controllers/arms/arm_cabinet.hpp"
#include "drivers/simulation/controllers/arms/ur_exchange.hpp"
#include "drivers/simulation/controllers/arms/ur_interface.hpp"
#include "drivers/simulation/controllers/arms/urscript.hpp"

namespace pizarra::simulation {

inline constexpr std::int32_t ur_mode_off = 3;
inline constexpr std::int32_t ur_mode_idle = 5;

class UrEmulator {
 public:
  // The cabinet outlives it.
  // `programs` has the text of those that the dashboard may load, by name.
  using Programs = std::function<std::optional<std::string>(std::string_view name)>;
  explicit UrEmulator(ArmCabinet& cabinet, Programs programs = {})
      : cabinet_(cabinet), executor_(cabinet.executor()), programs_(std::move(programs)) {}

  // A line to the dashboard and its answer.
  Task<std::string> dashboard(std::string line);
  // A program, as it came over a client interface, or one of the words that the interfaces take.
  void run(std::string_view program);
  // Takes the primary interface's messages about programs that were not sent yet.
  std::string take_said();
  bool powered() const { return cabinet_.powered(); }
  const arm::ArmModel& model() const { return cabinet_.model(); }
  std::uint64_t now_us() const;
  Task<UrState> state();
  // One message of RTDE and its answer; empty: none.
  Task<std::string> answer(std::string message);
  // How often the client wants to be told; none before it has started that.
  std::optional<Duration> told_every() const { return cabinet_.powered() ? exchange_.told_every() : std::nullopt; }
  std::string tell(const UrState& state) const { return exchange_.tell(state); }
  void forget_client() { exchange_ = UrExchange(); }

 private:
  static constexpr Duration look_again = 8ms;
  enum class Phase : std::uint8_t { stopped, playing, paused };
  bool command(std::string_view words);
  void start(std::string name, std::vector<UrStep> steps);
  void forget_program();
  Task<void> end_program();
  std::string load(std::string_view name);
  bool play();
  Task<bool> pause();
  Task<void> while_paused();
  Task<void> wait(Duration left);
  Task<void> carry_out(std::vector<UrStep> steps);
  Task<bool> move(std::vector<UrStep> moves);
  void set(const UrStep& step);
  void set_speed_slider(double fraction);
  void set_outputs(std::string_view bank);
  void say(std::string message);
  void switch_off();
  void release_brakes();
  std::int32_t robot_mode() const;
  std::string program_state() const;
  std::string safety(bool status) const;

  ArmCabinet& cabinet_;
  Executor& executor_;
  Programs programs_;
  bool energized_ = false;  // the arm has power, its brakes may be on
  Phase phase_ = Phase::stopped;
  std::string name_;  // of the program that runs, or ran, or was loaded
  std::optional<std::vector<UrStep>> loaded_;
  std::deque<std::string> said_;
  UrExchange exchange_;
  std::map<std::string, double, std::less<>> numbers_;  // registers and inputs, by their names in the data exchange
  std::uint32_t outputs_ = 0;                           // a bit each
  UrState told_;                                        // last, for how fast it is
  Time told_at_{};
  Job program_;
  Job ending_;
};

// Each until destroyed. All outlive them.
Task<void> serve_rtde(Executor& executor, UrEmulator& emulator, line::ByteWire& port);
enum class UrInterface : std::uint8_t { primary, secondary, real_time };
Task<void> serve_interface(Executor& executor, UrEmulator& emulator, UrInterface kind, line::ByteWire& port);
Task<void> serve_dashboard(Executor& executor, UrEmulator& emulator, line::ByteWire& port);

}  // namespace pizarra::simulation
