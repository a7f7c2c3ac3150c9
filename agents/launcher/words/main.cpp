// The program behind ./pizarra: every word that needs agents, world or language.

#include <cstdlib>
#include <opencv2/core.hpp>

#include "agents/launcher/command_line/command_line.hpp"
#include "agents/launcher/command_line/word_tools.hpp"
#include "agents/launcher/words/words.hpp"

int main(int argc, char** argv) {
  // One thread each: two runs of the same seed must not differ, and many runs share the cores.
  cv::setNumThreads(1);
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  app.set_version_flag("--version", pizarra::version());
  app.footer(pizarra::exit_code_help);
  int status = pizarra::exit_reached;
  pizarra::add_demo_word(app, status);
  pizarra::add_scenario_word(app, status);
  pizarra::add_check_word(app, status);
  pizarra::add_up_word(app, status);
  pizarra::add_ps_word(app, status);
  pizarra::add_down_word(app, status);
  pizarra::add_repl_word(app, status);
  pizarra::add_form_words(app, status);
  pizarra::add_look_word(app, status);
  pizarra::add_shapes_word(app, status);
  pizarra::add_calibrate_word(app, status);
  pizarra::add_top_word(app, status);
  pizarra::add_replay_word(app, status);
  return pizarra::run_program(app, argc, argv, status);
}
