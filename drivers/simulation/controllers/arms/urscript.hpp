#pragma once

// The lines of URScript that the emulated controller understands, as steps:
//
//   read_urscript("def p():\n  movej([0, -1.57, 1.57, -1.57, -1.57, 0], a=1, v=0.5, r=0.001)\nend\n")
//   read_urscript("movej(p[0.4, 0.1, 0.3, 0, 3.14, 0], 1.2, 0.25)\n")        // one line alone, arguments by place
//
// movej and movel to joint angles or poses, with a, v, t and r; stopj, stopl, sleep; the registers that a program may
// write; digital outputs; textmsg; popup and what sets the tool, which do nothing here; `def`, `sec`, `end`, comments.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lisp/result.hpp"

namespace pizarra::simulation {

struct UrStep {
  enum class Kind : std::uint8_t { move_joints, move_line, stop, set, digital_output, text, sleep, nothing };
  Kind kind;
  std::array<double, 6> target{};  // joints, rad; or a pose: m and a rotation vector
  bool pose = false;
  double speed = 1.05;     // rad/s, m/s
  double time_s = 0;       // that the move takes, whatever its speed; 0: none was said
  std::string field = {};  // what is set, by its name in the data exchange; or a text that is told
  int number = 0;          // of a digital output
  double value = 0;        // that is set; seconds of a sleep
};

// Failure: bad-script, the number of the line as its subject.
Result<std::vector<UrStep>> read_urscript(std::string_view program);

}  // namespace pizarra::simulation
