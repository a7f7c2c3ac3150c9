#pragma once

// How the program ends, the same for every word; docs and --help list them from here.

namespace pizarra::programs {

enum ExitCode : int {
  exit_reached = 0,       // done: the goal is reached, the answer given, the file in order
  exit_failed = 1,        // tried and not reached, or an expectation of a scenario not met
  exit_usage = 2,         // a wrong word or option, or a file or goal that cannot be read
  exit_refused = 3,       // the goal was understood and refused: nothing was begun, or it cannot be reached
  exit_unavailable = 4,   // no board answers, a file cannot be written, a process cannot be started
  exit_interrupted = 130  // Ctrl-C or SIGTERM
};

inline constexpr const char* exit_code_help =
    "Exit status: 0 done or reached; 1 not reached, or an expectation not met; 2 a wrong command, option, file or "
    "goal;\n"
    "3 the goal was refused (unreachable, missing, contradictory); 4 no board, file or process is available;\n"
    "130 interrupted.";

}  // namespace pizarra::programs
