#pragma once

// The words of the program: each adds its subcommand, with its help, and leaves its exit status where it is told.
//
//   CLI::App app;
//   int status = exit_reached;
//   add_check_command(app, status);
//   CLI11_PARSE(app, argc, argv);
//   return status;

#include <CLI/CLI.hpp>

namespace pizarra::programs {

void add_chaos_command(CLI::App& app, int& status);
void add_check_command(CLI::App& app, int& status);
void add_up_command(CLI::App& app, int& status);
void add_hosts_command(CLI::App& app, int& status);
void add_contexts_command(CLI::App& app, int& status);
void add_cells_command(CLI::App& app, int& status);
void add_host_command(CLI::App& app, int& status);
void add_ps_command(CLI::App& app, int& status);
void add_down_command(CLI::App& app, int& status);
void add_shapes_command(CLI::App& app, int& status);
void add_calibrate_command(CLI::App& app, int& status);
// Below `calibrate`.
void add_hand_eye_command(CLI::App& calibrate, int& status);
void add_find_command(CLI::App& app, int& status);
void add_measure_command(CLI::App& app, int& status);
void add_look_command(CLI::App& app, int& status);
void add_top_command(CLI::App& app, int& status);
void add_method_command(CLI::App& app, int& status);
void add_log_command(CLI::App& app, int& status);
void add_replay_command(CLI::App& app, int& status);
void add_repl_command(CLI::App& app, int& status);
void add_new_command(CLI::App& app, int& status);
void add_console_command(CLI::App& app, int& status);
void add_form_commands(CLI::App& app, int& status);  // declare, tell, retract, ask, watch, goal, why

}  // namespace pizarra::programs
