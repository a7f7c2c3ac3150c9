// The program behind ./pizarra: every word that needs agents, world or language.

#include <cstdlib>
#include <opencv2/core.hpp>

#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"

int main(int argc, char** argv) {
  // One thread each: two runs of the same seed must not differ, and many runs share the cores.
  cv::setNumThreads(1);
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", pizarra::version());
  app.footer(pizarra::exit_code_help);
  int status = pizarra::exit_reached;
  pizarra::add_demo_command(app, status);
  pizarra::add_scenario_command(app, status);
  pizarra::add_check_command(app, status);
  pizarra::add_up_command(app, status);
  pizarra::add_ps_command(app, status);
  pizarra::add_down_command(app, status);
  pizarra::add_repl_command(app, status);
  pizarra::add_form_commands(app, status);
  pizarra::add_look_command(app, status);
  pizarra::add_shapes_command(app, status);
  pizarra::add_calibrate_command(app, status);
  pizarra::add_top_command(app, status);
  pizarra::add_replay_command(app, status);
  return pizarra::run_program(app, argc, argv, status);
}
