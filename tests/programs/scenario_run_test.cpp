#include "programs/story/scenario_run.hpp"

#include <cstdio>
#include <gtest/gtest.h>

#include "agents/launcher/readiness.hpp"
#include "lisp/forms/arm_names.hpp"
#include "lisp/reader.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

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
  EXPECT_NE(whole_file(options.journal_file).find("(arm-pose slave "), std::string::npos);
}

struct Played {
  story::DirectorReport report;
  std::string told;
};

// The goal in the cell of the blocks, without a hand.
Played play(std::string_view goal, std::function<Task<void>(launcher::LocalCell&)> beside = {}) {
  forms::Scenario scenario;
  scenario.name = "stages";
  scenario.cell_file = source_dir() + "/examples/01-blocks/cell.scm";
  scenario.goal = {read_one(goal).value()};
  const forms::CellDescription cell = story::cell_of(scenario).value();
  story::StoryOptions options;
  options.beside = std::move(beside);
  const std::string path = scratch_folder() + "told.txt";
  std::FILE* out = std::fopen(path.c_str(), "w");
  story::Narrator narrator(out, story::Narrator::Style::plain);
  const Result<story::StoryReport> report = story::run_story(scenario, cell, options, narrator);
  std::fclose(out);
  return {report.value().director, whole_file(path)};
}

// Somebody else says that the first stage holds, as soon as the goal is given.
Task<void> say_too_early(launcher::LocalCell& cell) {
  const std::unique_ptr<Board> board = cell.board().view("liar");
  const Time deadline = cell.executor().now() + launcher::for_ever;
  Query given = query_from_datum(read_one("(goal-state 1 running ())").value()).value();
  co_await launcher::await_when_declared(*board, cell.executor(), std::move(given), deadline);
  const Datum said = read_one("(goal-state 1 running (stage 2))").value();
  co_await board->tell(said);
}

TEST(StoryRun, EachStageIsJudgedInTheWorldWhenTheNextBegins) {
  const Played played = play("(then (on circle triangle) (on-table circle))");
  EXPECT_TRUE(played.report.reached());
  EXPECT_TRUE(played.report.unmet.empty());
  EXPECT_NE(played.told.find("the world shows stage 1 of 2: (on circle triangle)"), std::string::npos) << played.told;
}

TEST(StoryRun, AStageThatTheWorldDidNotShowFailsTheStoryByName) {
  const Played played = play("(then (on circle triangle) (on-table circle))", say_too_early);
  EXPECT_EQ(played.report.outcome, "reached");
  EXPECT_TRUE(played.report.truth_holds);
  EXPECT_FALSE(played.report.reached());
  ASSERT_EQ(played.report.unmet.size(), 1U);
  EXPECT_EQ(played.report.unmet.front(),
            "the cell said that stage 1 of 2, (on circle triangle), holds, and in the world it did not");
  EXPECT_NE(played.told.find("the world does not show stage 1 of 2: (on circle triangle)"), std::string::npos);
}

}  // namespace
}  // namespace pizarra::programs
