#pragma once

// The words that play stories in virtual time, in one process: `demo` and `scenario`. Each adds its subcommand, with
// its help, and leaves its exit status where it is told.
//
//   CLI::App app;
//   int status = exit_reached;
//   add_demo_command(app, status);
//   CLI11_PARSE(app, argc, argv);
//   return status;

#include <CLI/CLI.hpp>

namespace pizarra::programs {

void add_demo_command(CLI::App& app, int& status);
void add_scenario_command(CLI::App& app, int& status);

}  // namespace pizarra::programs
