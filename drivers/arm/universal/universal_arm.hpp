#pragma once

// A Universal Robots arm (e-Series, CB3 from 3.5 on) as an ArmDriver: its state by RTDE, its motion as URScript, its
// power and mode by the dashboard server. Wrist 2 stands at -90 degrees (arms/ur5e.scm): the arm is driven as one of
// five axes, and refused where it stands otherwise.
//
//   UniversalArm arm(executor, {.rtde = rtde_wire, .script = script_wire, .dashboard = dashboard_wire}, model);
//
// A move is one program of movej and movel, blended through its waypoints, that says in integer register 24 which it is
// and, at last, that it has ended: so nothing is taken for begun or done that is not. The gripper is a daemon's of the
// controller: double input register 24 is the opening wanted, mm; double output register 24 the one measured; integer
// output register 25 is 1 while the fingers move.
//
// identify() goes by the dashboard server's model and version: an e-Series (PolyScope 5) says UR5 of a UR5e, as a CB3
// (PolyScope 3) does of a UR5, and the two differ in their links.
//
// take_control() refuses an arm in local control, releases a protective stop, switches on and releases the brakes. A
// stop is a program of its own and, at the same time, the dashboard server's word, since neither can be known to
// arrive.
//
// How far it is proven: docs/write-a-driver.md. Facts from: the maker's RTDE guide, URScript manual and dashboard
// server documentation.

#include "drivers/arm/arm_driver.hpp"
#include "drivers/arm/universal/rtde.hpp"
#include "drivers/line/told_state.hpp"

namespace pizarra::arm {

struct UniversalWires {
  line::ByteWire& rtde;
  line::ByteWire& script;
  line::ByteWire& dashboard;
};

class UniversalArm : public ArmDriver {
 public:
  // The wires outlive it.
  UniversalArm(Executor& executor, UniversalWires wires, ArmModel model);
  Task<Result<std::string>> identify() override;
  Task<Result<void>> take_control() override;
  Task<Result<void>> release_control() override;
  Task<Result<void>> start_move(std::vector<Joints> waypoints, double speed) override;
  Task<Result<void>> stop() override;
  Task<Result<void>> start_gripper(double opening_mm) override;
  Task<Result<ArmReading>> read() override;

 private:
  static constexpr double told_per_s = 125;
  static constexpr Duration answer_time = 1s;
  static constexpr Duration fresh = 200ms;  // what the arm said longer ago is not known any more
  static constexpr Duration power_time = 20s;
  static constexpr Duration mode_time = 500ms;     // while it does not move for us: local control is not told unasked
  static constexpr Duration standing_time = 40ms;  // several states
  static constexpr Duration look_again = 3600s;

  Task<Result<std::string>> ask_rtde(char type, std::string payload);
  Task<Result<void>> subscribe();
  Task<Result<std::string>> ask_type();
  Task<Result<void>> ask_mode();
  Task<void> ask_mode_again();
  Task<Result<void>> open_script(Time deadline);
  Task<void> pass_over_chatter();
  Task<Result<void>> end_program();
  Task<void> end_program_too();
  Result<bool> hear(const std::string& message);
  bool able() const;
  Failure trouble() const;
  bool playing() const { return state_.runtime == rtde::playing; }
  // A program that is stopped ends before the arm stands.
  bool brakes() const { return stopping_ && executor_.now() - moved_at_ < standing_time; }
  bool ended() const { return state_.marker == 2 * programs_ + 1; }  // the last program
  Joints joints() const;

  Executor& executor_;
  ArmModel model_;
  line::ByteWire& script_;  // is told programs
  line::Dialogue rtde_;
  line::Dialogue dashboard_;
  line::ToldState told_;
  rtde::State state_;
  std::uint8_t input_recipe_ = 0;
  std::int32_t programs_ = 0;  // the last begins with the marker 2 N and ends with 2 N + 1
  bool stopping_ = false;
  Time moved_at_{};
  bool local_ = false;  // the pendant has control
  Time mode_asked_at_{};
  Job asking_mode_;
  Job passing_over_;
  Job ending_;
  Time gripping_until_{};
};

}  // namespace pizarra::arm
