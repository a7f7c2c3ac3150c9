#pragma once

// The operations that move something: motions, held jogs, the gripper. Each is begun and ended on the board, so that
// nothing is moved twice.
//
//   MovingOperations moving(parts);
//   if (MovingOperations::has(operation)) answer = co_await moving.run(request);

#include "agents/robot/robot_parts.hpp"

namespace pizarra::robot {

class MovingOperations {
 public:
  explicit MovingOperations(RobotParts& robot) : robot_(robot) {}

  static bool has(const Datum& operation);
  Task<Result<Datum>> run(Fact request);

 private:
  bool holds_something(const arm::ArmReading& reading) const;
  Task<Result<Datum>> move(Fact request);
  Task<Result<Datum>> jog(Fact request);
  Task<Result<void>> follow_while_held(std::string client, Duration deadline, arm::Joints from,
                                       std::vector<arm::Joints> waypoints);
  Task<Result<Datum>> grip(Fact request);
  Task<Result<Datum>> carry_out(Fact request, Task<Result<void>> motion);

  RobotParts& robot_;
  std::optional<double> fingers_sent_mm_;  // to which opening, in this life
};

}  // namespace pizarra::robot
