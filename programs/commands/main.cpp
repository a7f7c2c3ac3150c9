// The program behind ./pizarra: every word that needs agents, world or language.

#include <cstdlib>
#include <opencv2/core.hpp>

#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"
#include "programs/play/play_commands.hpp"

int main(int argc, char** argv) {
  // One thread each: two runs of the same seed must not differ, and many runs share the cores.
  cv::setNumThreads(1);
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", pizarra::programs::version());
  app.footer(pizarra::programs::exit_code_help);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_demo_command(app, status);
  pizarra::programs::add_scenario_command(app, status);
  pizarra::programs::add_chaos_command(app, status);
  pizarra::programs::add_check_command(app, status);
  pizarra::programs::add_up_command(app, status);
  pizarra::programs::add_hosts_command(app, status);
  pizarra::programs::add_contexts_command(app, status);
  pizarra::programs::add_cells_command(app, status);
  pizarra::programs::add_host_command(app, status);
  pizarra::programs::add_ps_command(app, status);
  pizarra::programs::add_down_command(app, status);
  pizarra::programs::add_repl_command(app, status);
  pizarra::programs::add_console_command(app, status);
  pizarra::programs::add_new_command(app, status);
  pizarra::programs::add_form_commands(app, status);
  pizarra::programs::add_look_command(app, status);
  pizarra::programs::add_find_command(app, status);
  pizarra::programs::add_measure_command(app, status);
  pizarra::programs::add_shapes_command(app, status);
  pizarra::programs::add_calibrate_command(app, status);
  pizarra::programs::add_top_command(app, status);
  pizarra::programs::add_method_command(app, status);
  pizarra::programs::add_log_command(app, status);
  pizarra::programs::add_replay_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
