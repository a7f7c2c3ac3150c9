#pragma once

// The words of the program: each adds its subcommand, with its help, and leaves its exit status where it is told.
//
//   CLI::App app;
//   int status = exit_reached;
//   add_demo_word(app, status);
//   CLI11_PARSE(app, argc, argv);
//   return status;

#include <CLI/CLI.hpp>

#include "agents/launcher/exit_codes.hpp"
#include "lisp/result.hpp"

namespace pizarra {

void add_demo_word(CLI::App& app, int& status);
void add_scenario_word(CLI::App& app, int& status);
void add_check_word(CLI::App& app, int& status);
void add_cell_words(CLI::App& app, int& status);     // up, ps, down
void add_process_words(CLI::App& app, int& status);  // agent, world
void add_replay_word(CLI::App& app, int& status);
void add_board_words(CLI::App& app, int& status);    // repl, tell, retract, ask, watch, goal, why

// Prints the failure to standard error and answers `code`.
int complain(const Failure& failure, ExitCode code);

// For options that take a seed: digits alone, from 0 to 2^64-1.
CLI::Validator seed_check();

// "1 cube", "4 cubes".
std::string counted(std::size_t number, std::string_view thing);

// A file that comes with the program: from the tree it was built from.
std::string shipped_file(const std::string& path);

}  // namespace pizarra
