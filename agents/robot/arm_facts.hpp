#pragma once

// The facts that the board is told about the arm: state, pose, foot, joints, gripper opening and grip, each when it
// changed, under the agent's presence, so that they go with it. At rest, why the controller would not move goes before
// what was last done.
//
//   facts.set_arm("moving", "(home)");
//   facts.set_reading(model, reading);
//   Result<void> told = co_await facts.tell();      // one transaction with what changed, none where nothing did

#include <array>

#include "agents/runtime/service.hpp"
#include "drivers/arm/arm_driver.hpp"

namespace pizarra::robot {

class ArmFacts {
 public:
  ArmFacts(runtime::AgentContext& context, const runtime::Service& service)
      : context_(context), service_(service), robot_(Datum::symbol(context.name)) {}

  // STATE idle, moving, stopped or fault; the action stays where none is given.
  void set_arm(std::string_view state, std::string action);
  void set_arm(std::string_view state) { set_arm(state, action_); }
  void set_reading(const arm::ArmModel& model, const arm::ArmReading& reading);
  void set_trouble(std::optional<arm::ArmTrouble> trouble);
  // Where the arm is and what it holds is not known any more.
  void forget_reading();
  // The last commanded action, NO_ACTION before the first.
  const std::string& action() const { return action_; }

  // Whether there is something to tell.
  bool changed() const;
  // Tells what changed, and `with` it.
  Task<Result<void>> tell(Transaction with = {});
  // The same, again and again while the board cannot be reached.
  Task<Result<void>> tell_surely(Transaction with = {});
  // Everything is told again next time: a board that restarted has forgotten it.
  void forget_told();

 private:
  struct Told {
    Datum now;                            // empty: not known
    std::optional<Datum> told = Datum();  // empty: nothing; none: perhaps something
  };
  enum : std::size_t { arm, pose, foot, joints, gripper, gripped, kinds };

  void set_state_fact();
  Datum pattern(std::size_t kind) const;

  runtime::AgentContext& context_;
  const runtime::Service& service_;
  LeaseId told_under_ = 0;
  const Datum robot_;  // the key of all of them
  std::string state_;
  std::string action_ = "NO_ACTION";
  std::optional<arm::ArmTrouble> trouble_;
  std::array<Told, kinds> facts_;
};

// x, y, z (0.01 mm) and rx, ry, rz (0.001 degree, each in (-180, 180]) of the grip centre.
std::vector<Datum> pose_numbers(const arm::ArmModel& model, const arm::Joints& joints);
// x and y (0.01 mm) of the point about which the arm turns: the base's origin, unless a track carries axis 1 along.
std::vector<Datum> foot_numbers(const arm::ArmModel& model, const arm::Joints& joints);
// The axes' readings, axis 1 first: 0.001 degree or mm.
std::vector<Datum> joint_numbers(const arm::Joints& joints);

// The axes' positions as a list, exactly, and back; nothing where it is no such list.
Datum joints_to_datum(const arm::Joints& joints);
std::optional<arm::Joints> joints_from_datum(const Datum& datum);

}  // namespace pizarra::robot
