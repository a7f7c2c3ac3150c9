// `down` ends what was named: a cell on all its hosts of this machine, or on one.

#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <memory>

#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;

Said run(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1"); }

class Down : public testing::Test {
 protected:
  void up(const std::string& cell, const std::string& host) {
    const std::string file = scratch_folder() + cell + ".scm";
    std::ofstream(file) << fmt::format(
        "(cell {} (world (cube circle (at 450 0))) (domain \"{}/domains/blocks.scm\") (board \"bench\" "
        "\"ipc://{}.ipc\")"
        " (host \"bench\" (agents planner)) (host \"desk\" (agents coordinator)))\n",
        cell, source_dir(), scratch_folder() + cell);
    const std::string name = cell + "@" + host;
    running_[name] = std::make_unique<Running>(std::vector<std::string>{PIZARRA_CELL, "up", file, "--host", host},
                                               scratch_folder() + name + ".log");
    const std::string row = fmt::format("cell {} on {},", cell, host);
    ASSERT_TRUE(wait_until([&] { return run("ps").text.contains(row); }, seconds(60))) << running_[name]->said();
  }
  bool ended(const std::string& name) { return running_.at(name)->end(seconds(0)).has_value(); }

  std::map<std::string, std::unique_ptr<Running>> running_;
};

TEST_F(Down, EndsACellOnAllItsHostsOfThisMachineAndSaysSo) {
  up("pair", "bench");
  up("pair", "desk");
  up("other", "bench");
  const Said unclear = run("down");
  EXPECT_EQ(unclear.status, 4) << unclear.text;
  EXPECT_TRUE(unclear.text.contains("several cells run here, other and pair among them: name one")) << unclear.text;
  EXPECT_TRUE(run("down piar").text.contains("no cell named piar runs here; did you mean pair?"));
  const Said said = run("down pair");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(said.text.contains("pair on bench, process ") && said.text.contains("pair on desk, process "))
      << said.text;
  EXPECT_EQ(running_.at("pair@bench")->end(seconds(60)), 0);
  EXPECT_EQ(running_.at("pair@desk")->end(seconds(60)), 0);
  EXPECT_FALSE(ended("other@bench"));
}

TEST_F(Down, EndsTheHostAloneThatIsNamed) {
  up("pair", "bench");
  up("pair", "desk");
  const Said none = run("down pair --host attic");
  EXPECT_EQ(none.status, 4) << none.text;
  EXPECT_TRUE(none.text.contains("no cell named pair runs here on the host attic")) << none.text;
  const Said said = run("down pair --host desk");
  EXPECT_EQ(said.status, 0) << said.text;
  EXPECT_TRUE(said.text.starts_with("pair on desk, process ") && said.text.ends_with(", has ended\n")) << said.text;
  EXPECT_EQ(running_.at("pair@desk")->end(seconds(60)), 0);
  EXPECT_FALSE(ended("pair@bench"));
}

}  // namespace
}  // namespace pizarra::programs
