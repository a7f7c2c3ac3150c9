// pizarra-story: the words that play stories, in a program of their own. It is built in half the time of pizarra-cell,
// which has them too.

#include <opencv2/core.hpp>

#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/play/play_commands.hpp"

int main(int argc, char** argv) {
  // One thread each: two runs of the same seed must not differ, and many runs share the cores.
  cv::setNumThreads(1);
  CLI::App app("Stories of a simulated cell, in virtual time.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", pizarra::programs::version());
  app.footer(pizarra::programs::exit_code_help);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_demo_command(app, status);
  pizarra::programs::add_scenario_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
