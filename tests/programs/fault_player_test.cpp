// Faults that nobody draws or plays: a mistake of the program, which shows at once.

#include <cstdio>
#include <gtest/gtest.h>

#include "programs/chaos/chaos_run.hpp"
#include "programs/chaos/draw_faults.hpp"
#include "tests/programs/four_cubes.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::chaos {
namespace {

ChaosStory story_with(Fault fault) {
  const auto cell = forms::read_cell_file(source_dir() + "/examples/01-blocks/cell.scm").value();
  ChaosStory story = draw_story(cell, 1, {});
  story.faults = {std::move(fault)};
  return story;
}

void play_alone(Fault fault) {
  story::Narrator narrator(stdout, story::Narrator::style_for(stdout, false));
  [[maybe_unused]] const Result<RunResult> played = play(story_with(std::move(fault)), {}, narrator);
}

TEST(FaultPlayer, EndsTheProgramWhereItKnowsNoSuchFault) {
  EXPECT_DEATH(play_alone({"fog", {}, list("fog"_sym, 0.4, 3.0)}), "each fault that is drawn is played");
}

TEST(FaultPlayer, EndsTheProgramWhereItsClassHasNoSuchFault) {
  EXPECT_DEATH(play_alone({"network", {}, list("fog"_sym, 0.4, 3.0)}), "each fault of the network is played");
  EXPECT_DEATH(play_alone({"disk", {}, list("fog"_sym, 3.0)}), "each fault of the disk is played");
  EXPECT_DEATH(play_alone({"frames", {}, list("fog"_sym, 3.0)}), "each fault of the camera is played");
  EXPECT_DEATH(play_alone({"arm", {}, list("fog"_sym, 3.0)}), "each fault of the arm is played");
}

TEST(FaultPlayer, NoFaultIsDrawnForAClassThatHasNone) {
  EXPECT_DEATH(draw_faults("fog", programs::four_cubes(), {}, 12, Random(1)), "each class has faults that are drawn");
}

}  // namespace
}  // namespace pizarra::chaos
