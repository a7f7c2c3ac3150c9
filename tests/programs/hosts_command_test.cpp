// `hosts`: who is in a cell.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <zmq.hpp>

#include "blackboard/wire/wire.hpp"
#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;
namespace files = std::filesystem;

class HostsOfACell : public testing::Test {
 protected:
  void SetUp() override {
    files::remove_all(folder_);
    files::create_directories(folder_);
    write_cell("tcp://127.0.0.1:7943");
  }
  void write_cell(const std::string& address) {
    std::ofstream(cell_) << "(cell two-hosts (world (cube circle (at 450 -80))) (domain \"" << source_dir()
                         << "/domains/blocks.scm\") (board \"bench\" \"" << address
                         << "\") (host \"bench\" (agents robot vision)) (host \"desk\" (agents planner)))\n";
  }
  static Said run(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1"); }
  // The address that it listens at.
  std::string comes_up(const Running& board) {
    const auto ready = [&] { return board.said().contains("ready on "); };
    EXPECT_TRUE(wait_until(ready, seconds(60))) << board.said();
    const std::string said = board.said();
    const std::size_t begin = said.find("ready on ") + std::string("ready on ").size();
    return said.substr(begin, said.find_first_of(" \n", begin) - begin);
  }
  const std::string folder_ = scratch_folder() + "hosts/";
  const std::string cell_ = folder_ + "two hosts.scm";
};

TEST_F(HostsOfACell, AreShownWithThoseWhoseBuildTheBoardCannotSpeakWith) {
  const Running board({PIZARRA_BOARD, "--listen", "ipc://" + folder_ + "board.ipc"}, folder_ + "board.log");
  const std::string address = comes_up(board);
  write_cell(address);
  const std::string hosts = "hosts '" + cell_ + "'";
  EXPECT_FALSE(run(hosts).text.contains("refused")) << run(hosts).text;
  zmq::context_t context;
  zmq::socket_t stranger(context, zmq::socket_type::dealer);
  stranger.set(zmq::sockopt::linger, 0);
  stranger.connect(address);
  ASSERT_TRUE(stranger.send(zmq::str_buffer("(hello \"desk\" 0 9)")));
  const std::string sentence = "refused who comes without a key: the client speaks protocol 9 and the board protocol " +
                               std::to_string(wire::protocol) + ", more than one apart: bring the board up to date\n";
  EXPECT_TRUE(wait_until([&] { return run(hosts).text.contains(sentence); }, seconds(60))) << run(hosts).text;
  const Said json = run(hosts + " --json");
  EXPECT_EQ(json.status, 0) << json.text;
  EXPECT_TRUE(json.text.contains("{\"refused\":\"\",\"newest\":\"the client speaks protocol 9 ")) << json.text;
}

}  // namespace
}  // namespace pizarra::programs
