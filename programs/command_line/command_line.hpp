#pragma once

// How every program of ours begins and ends: a wrong command line is told in one line, with the nearest word or option,
// and an answer that could not be written is no success.
//
//   int status = exit_reached;
//   add_plan_command(app, status);                   // its callback leaves the status
//   return run_program(app, argc, argv, status);
//
// A program whose output nobody reads any more ends with exit_interrupted, as by Ctrl-C, at the next line it prints,
// unless it has StopSignals, which end it in order.

#include <CLI/CLI.hpp>

namespace pizarra::programs {

// Prints why a command line was not taken, naming what is not known, or the help that was asked for; answers the exit
// status.
int end_of_parsing(const CLI::App& app, const CLI::ParseError& error);

// Runs the word that was typed and answers its status, exit_unavailable where standard output could not be written.
int run_program(CLI::App& app, int argc, char** argv, const int& status);

}  // namespace pizarra::programs
