#include "programs/play/random_runs.hpp"

#include <gtest/gtest.h>

#include "programs/command_line/exit_codes.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

TEST(RandomRuns, ASeedThatDoesNotEndInTimeHasNotFailed) {
  RandomRuns runs;
  runs.cell_file = source_dir() + "/examples/01-blocks/cell.scm";
  runs.seeds = 1;
  runs.jobs = 1;
  runs.longest_run = std::chrono::seconds(0);
  testing::internal::CaptureStdout();
  const int status = run_random(runs);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_EQ(status, exit_unavailable);
  EXPECT_NE(said.find("seed     1  timed out  no end within 0 s"), std::string::npos) << said;
  EXPECT_TRUE(said.ends_with("\nreached 0, refused correctly 0, failed 0, timed out 1\n")) << said;
}

}  // namespace
}  // namespace pizarra::programs
