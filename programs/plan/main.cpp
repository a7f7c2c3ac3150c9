// pizarra-plan: the planner on files. It links Guile for what people write, but neither OpenCV nor Bullet, so that it
// starts at once.

#include "programs/command_line/command_line.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/plan/plan_command.hpp"

int main(int argc, char** argv) {
  CLI::App app("Pizarra, a blackboard for robot cells.", "pizarra");
  app.require_subcommand(1);
  int status = pizarra::programs::exit_reached;
  pizarra::programs::add_plan_command(app, status);
  return pizarra::programs::run_program(app, argc, argv, status);
}
