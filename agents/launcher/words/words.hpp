#pragma once

// The words of the program: each adds its subcommand, with its help, and leaves its exit status where it is told.
//
//   CLI::App app;
//   int status = exit_reached;
//   add_demo_word(app, status);
//   CLI11_PARSE(app, argc, argv);
//   return status;

#include <CLI/CLI.hpp>

namespace pizarra {

void add_demo_word(CLI::App& app, int& status);
void add_scenario_word(CLI::App& app, int& status);
void add_check_word(CLI::App& app, int& status);
void add_up_word(CLI::App& app, int& status);
void add_ps_word(CLI::App& app, int& status);
void add_down_word(CLI::App& app, int& status);
void add_shapes_word(CLI::App& app, int& status);
void add_calibrate_word(CLI::App& app, int& status);
void add_look_word(CLI::App& app, int& status);
void add_top_word(CLI::App& app, int& status);
void add_replay_word(CLI::App& app, int& status);
void add_repl_word(CLI::App& app, int& status);
void add_form_words(CLI::App& app, int& status);  // declare, tell, retract, ask, watch, goal, why

}  // namespace pizarra
