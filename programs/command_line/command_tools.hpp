#pragma once

// Tools for every word of every program: how it complains, counts, checks a seed and finds a file of ours.
//
//   if (!journal) return complain(journal.failure(), exit_unavailable);

#include <CLI/CLI.hpp>

#include "lisp/result.hpp"
#include "lisp/shipped.hpp"
#include "programs/command_line/exit_codes.hpp"

namespace pizarra::programs {

// Prints the failure to standard error and answers `code`.
int complain(const Failure& failure, ExitCode code);

// The end of a command's help: how it is typed, after `./pizarra`, and its exit status.
std::string help_footer(std::string_view example, std::string_view exit_codes = exit_code_help);

// As `--version` tells it.
std::string version();

// For options that take a seed: digits alone, from 0 to 2^64-1.
CLI::Validator seed_check();
// A number within these bounds: CLI::Range lets `nan` through, which compares with nothing.
CLI::Validator number_check(double least, double most);

// "1 cube", "4 cubes".
std::string counted(std::size_t number, std::string_view thing);

// Another of our programs, where this one is.
std::string beside_this_program(const std::string& name);

}  // namespace pizarra::programs
