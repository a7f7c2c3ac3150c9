// Runs one agent that is a Scheme file, in a process of its own.

#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/scheme/scheme_command.hpp"

int main(int argc, char** argv) {
  CLI::App app("An agent that is a Scheme file.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", pizarra::programs::version());
  app.footer(pizarra::programs::exit_code_help);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_scheme_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
