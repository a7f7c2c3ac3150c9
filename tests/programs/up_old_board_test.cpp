// A cell on a board whose relations, as its journal kept them, are those of another version of the agents.

#include <fstream>
#include <gtest/gtest.h>

#include "tests/programs/declare_at.hpp"
#include "tests/programs/running.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;

TEST(UpOnAnOldBoard, SaysOnceAndForAllWhichAgentCannotRunThereAndWhy) {
  const std::string folder = scratch_folder();
  const std::string address = "ipc://" + folder + "board.ipc";
  const Running board({PIZARRA_BOARD, "--listen", address, "--journal", folder + "old.journal"}, folder + "board.log");
  ASSERT_TRUE(declare_at(address, "(relation planner ((state symbol)) (key))"));
  std::ofstream(folder + "cell.scm") << "(cell old (world (cube circle (at 450 0))) (domain \"" << source_dir()
                                     << "/domains/blocks.scm\") (host \"localhost\" (agents planner)))\n";
  Running up({PIZARRA_CELL, "up", folder + "cell.scm", "--board", address}, folder + "up.log");
  const std::string sentence =
      "planner: pizarra: the relation planner is declared differently already, by another version of the agents: begin "
      "with a board, and a journal, of its own";
  EXPECT_TRUE(wait_until([&] { return up.said().contains(sentence); }, seconds(60))) << up.said();
  EXPECT_FALSE(up.said().contains("starts again")) << up.said();
  up.signal(SIGTERM);
  EXPECT_EQ(up.end(seconds(20)), 0) << up.said();
}

}  // namespace
}  // namespace pizarra::programs
