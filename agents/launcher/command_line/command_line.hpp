#pragma once

// How every program of ours says that its command line is wrong: one line, with the nearest word or option.
//
//   try { app.parse(argc, argv); } catch (const CLI::ParseError& error) { return end_of_parsing(app, error); }

#include <CLI/CLI.hpp>

namespace pizarra {

// Prints why a command line was not taken, naming what is not known, or the help that was asked for; answers the exit
// status.
int end_of_parsing(const CLI::App& app, const CLI::ParseError& error);

}  // namespace pizarra
