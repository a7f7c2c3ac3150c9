#pragma once

// The operations that move nothing. Reports and the stop are open to all, and are answered while a motion runs; the
// others change what the robot is set to, and are its commander's to ask for.
//
//   RestingOperations resting(parts);
//   if (RestingOperations::is_open_to_all(operation)) answer = co_await resting.run(request);

#include "agents/robot/robot_parts.hpp"

namespace pizarra::robot {

class RestingOperations {
 public:
  explicit RestingOperations(RobotParts& robot) : robot_(robot) {}

  static bool is_open_to_all(const Datum& operation);
  Task<Result<Datum>> run(Fact request);

 private:
  Task<Result<Datum>> get_status();
  Task<Result<Datum>> monitor();
  Task<Result<Datum>> finish(Datum operation);
  Task<Result<Datum>> speed(Datum operation);
  Task<Result<Datum>> learn(Datum operation);
  Task<Result<Datum>> get_control(Datum operation);
  Task<Result<Datum>> release_control(Fact request);

  RobotParts& robot_;
};

}  // namespace pizarra::robot
