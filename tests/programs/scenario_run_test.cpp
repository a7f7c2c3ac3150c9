#include "programs/story/scenario_run.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <sstream>

#include "lisp/forms/arm_names.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(StoryRun, BothArmsOfACellAreSimulatedWhateverControllersTheyHave) {
  forms::Scenario scenario;
  scenario.name = "two arms";
  scenario.cell_file = source_dir() + "/examples/01-blocks/cell.scm";
  scenario.goal = {list("on"_sym, "circle"_sym, "triangle"_sym)};
  Result<forms::CellDescription> cell = story::cell_of(scenario);
  ASSERT_TRUE(cell) << describe(cell.error());
  // Nobody listens there.
  const forms::ArmLine line{.protocol = "hses", .places = {"127.0.0.1"}, .ports = {1}, .gripper = {}};
  cell->arm_line = line;
  cell->slave =
      forms::CellSlave{.arm_file = forms::shipped_arm_file("motoman-up6"), .room = {}, .line = line, .offset_mm = {}};
  cell->hosts.front().agents.push_back("slave");
  story::StoryOptions options;
  options.journal_file = scratch_folder() + "journal.txt";
  story::Narrator narrator(stdout, story::Narrator::Style::plain);

  const Result<story::StoryReport> report = story::run_story(scenario, *cell, options, narrator);
  ASSERT_TRUE(report) << describe(report.error());
  EXPECT_TRUE(report->director.reached());
  EXPECT_NE(text_of(options.journal_file).find("(arm-pose slave "), std::string::npos);
}

}  // namespace
}  // namespace pizarra::programs
