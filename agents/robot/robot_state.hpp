#pragma once

// The state of the robot agent. robot_agent.cpp runs it and has its earlier life back; robot_operations.cpp takes
// what is asked and moves the arm; resting_operations.cpp has the operations that move nothing.

#include "agents/robot/arm_control.hpp"
#include "agents/robot/holds.hpp"
#include "agents/robot/motion.hpp"
#include "agents/robot/reflex.hpp"
#include "agents/robot/robot_agent.hpp"
#include "agents/runtime/service.hpp"

namespace pizarra::robot {

// The newest motion of an earlier life, and what its request is answered.
struct EarlierMotion {
  Datum request;
  Result<Datum> answer;
};

struct RobotAgent::State {
  State(runtime::AgentContext given, arm::ArmDriver& driver, arm::ArmModel described, const RobotOptions& options);

  runtime::AgentContext context;
  const Datum name;  // the first argument of all that it tells
  const arm::ArmModel model;
  const std::optional<WorkVolume> room;
  ArmFacts facts;
  ArmConnection connection;
  ArmControl control;
  Reflex reflex;
  Holds holds;
  ArmVariables variables;
  double speed_percent = 100;
  std::optional<double> fingers_sent_mm;  // to which opening, in this life
  std::optional<EarlierMotion> earlier;
  Job watch;
  runtime::Service service;  // last, because its jobs use all the others

  Task<Result<void>> run();
  Task<Result<std::vector<Fact>>> known(Datum pattern);
  Task<Result<void>> restore();
  Task<void> tell_properties();
  Task<Result<void>> connect();

  Task<Result<Datum>> handle(Fact request);
  Task<Result<Datum>> answer_monitor(Datum operation);
  Task<Result<Datum>> answer_with(Result<Datum> known);
  Task<Result<Datum>> get_status();
  bool holds_something(const arm::ArmReading& reading) const;
  Task<Result<Datum>> move(Fact request);
  Task<Result<Datum>> jog(Fact request);
  Task<Result<void>> follow_while_held(std::string client, Duration deadline, arm::Joints from,
                                       std::vector<arm::Joints> waypoints);
  Task<Result<Datum>> gripper(Fact request);
  Task<Result<Datum>> carry_out(Fact request, Task<Result<void>> motion);
  Task<Result<Datum>> speed(Datum operation);
  Task<Result<Datum>> learn(Datum operation);
  Task<Result<Datum>> monitor();
  Task<Result<Datum>> finish(Datum operation);
  Task<Result<Datum>> get_control(Datum operation);
  Task<Result<Datum>> release_control(Fact request);

  static Datum answer(bool done) { return list(done ? "true"_sym : "false"_sym); }
  Datum released_fact(const Datum& client) const { return list("robot-released"_sym, name, client); }
  Datum motion_fact(const Datum& request, const Datum& outcome) const {
    return list("robot-motion"_sym, name, request, outcome);
  }
};

}  // namespace pizarra::robot
