#pragma once

// The few lines of URScript that the emulated controller understands, as steps:
//
//   read_urscript("def p():\n  movej([0, -1.57, 1.57, -1.57, -1.57, 0], a=1, v=0.5, r=0.001)\nend\n")
//
// movej and movel to joint angles, stopj, write_output_integer_register, sleep; `def`, `end` and comments.

#include <array>
#include <string_view>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::simulation {

struct UrStep {
  enum class Kind : std::uint8_t { move_joints, move_line, stop, write_register, sleep };
  Kind kind;
  std::array<double, 6> joints_rad{};
  double speed = 1.05;  // rad/s, m/s
  int number = 0;       // of a register
  double value = 0;     // of a register; seconds of a sleep
};

// Failure: bad-script, with the line.
Result<std::vector<UrStep>> read_urscript(std::string_view program);

}  // namespace pizarra::simulation
