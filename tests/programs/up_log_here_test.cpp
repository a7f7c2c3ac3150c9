// A cell whose hosts run the members of its log themselves: here three hosts of one machine.

#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <memory>

#include "tests/blackboard/cluster/real_etcd.hpp"
#include "tests/free_port.hpp"
#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;

class UpWithLogHere : public testing::Test {
 protected:
  void SetUp() override {
    if (!cluster::RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    for (const char* host : {"a", "b", "c"}) std::filesystem::remove_all(scratch_folder() + "member-" + host);
    for (const char* host : {"a", "b", "c"}) members_[host] = fmt::format("127.0.0.1:{}", two_free_ports());
    board_ = fmt::format("tcp://127.0.0.1:{}", free_port());
    standby_ = fmt::format("tcp://127.0.0.1:{}", free_port());
    std::ofstream(cell_) << fmt::format(
        "(cell here (world (cube circle (at 450 -60))) (domain \"{}/domains/blocks.scm\")\n"
        " (board \"a\" \"{},{}\")\n"
        " (host \"a\" (agents robot vision person)) (host \"b\" (agents planner)) (host \"c\" (agents coordinator)))\n",
        source_dir(), board_, standby_);
  }
  std::string log() const {
    return fmt::format("etcd://{},{},{}/here", members_.at("a"), members_.at("b"), members_.at("c"));
  }
  void up(const std::string& host, const std::vector<std::string>& more) {
    std::vector<std::string> words = {PIZARRA_CELL,
                                      "up",
                                      cell_,
                                      "--host",
                                      host,
                                      "--log",
                                      log(),
                                      "--log-here",
                                      members_.at(host),
                                      "--log-folder",
                                      scratch_folder() + "member-" + host};
    words.insert(words.end(), more.begin(), more.end());
    running_[host] = std::make_unique<Running>(words, scratch_folder() + "up-" + host + ".log");
  }
  Said run(const std::string& words) const {
    return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words + " --board " + board_ + "," + standby_);
  }
  bool comes(const std::string& words, const std::string& wanted) const {
    return wait_until([&] { return run(words).text.contains(wanted); }, seconds(120));
  }
  void begin_log() {
    up("a", {});
    up("b", {"--standby", standby_});
    up("c", {});
    ASSERT_TRUE(comes("ask '(agent coordinator ?kind ?host)'", "?host = \"c\"")) << said();
    ASSERT_EQ(run("declare '(relation note ((n integer)) (key n) (durable))'").status, 0) << said();
    ASSERT_EQ(run("tell '(note 1)'").status, 0) << said();
  }
  void end(const std::string& host) {
    running_.at(host)->signal(SIGTERM);
    EXPECT_TRUE(running_.at(host)->end(seconds(60)).has_value()) << host;
  }
  bool is_healthy(const std::string& host) const {
    return shell_in_scratch("curl -s http://" + members_.at(host) + "/health").text.contains("true");
  }
  std::string said() const {
    std::string all;
    for (const auto& [host, up] : running_) all += "--- " + host + "\n" + up->said();
    return all;
  }

  const std::string cell_ = scratch_folder() + "here.scm";
  std::map<std::string, std::string> members_;
  std::string board_;
  std::string standby_;
  std::map<std::string, std::unique_ptr<Running>> running_;
};

TEST_F(UpWithLogHere, KeepsWhatIsDurableWhenTheHostOfTheFirstBoardAndItsMemberEnd) {
  begin_log();
  end("a");
  EXPECT_TRUE(comes("ask '(note ?n)'", "?n = 1")) << said();
  EXPECT_TRUE(comes("hosts " + cell_, "\nb                leads ")) << run("hosts " + cell_).text;
  EXPECT_EQ(run("tell '(note 2)'").status, 0) << said();
  // The same member again, behind what it missed.
  up("a", {});
  EXPECT_TRUE(comes("ask '(agent robot ?kind ?host)'", "?host = \"a\"")) << said();
  EXPECT_EQ(run("ask '(note ?n)'").text, "?n = 1\n?n = 2\n") << said();
}

TEST_F(UpWithLogHere, GoesOnWithItsMemberWhereItsBoardCannotListen) {
  const Running other({PIZARRA_BOARD, "--listen", standby_}, scratch_folder() + "other.log");
  ASSERT_TRUE(wait_until([&] { return other.said().contains("ready on"); }, seconds(60)));
  up("b", {"--standby", standby_});
  const auto fault_is_told = [&] { return running_.at("b")->said().contains("board: pizarra-board: ZeroMQ refuses"); };
  ASSERT_TRUE(wait_until(fault_is_told, seconds(60))) << said();
  // A log is begun by all.
  up("a", {});
  up("c", {});
  const auto board_leads = [&] {
    const std::string note = "'(relation note ((n integer)) (key n) (durable))'";
    return shell(fmt::format("{} declare --board {} {}", PIZARRA_CELL, board_, note)).status == 0;
  };
  EXPECT_TRUE(wait_until(board_leads, seconds(120))) << said();
  EXPECT_FALSE(running_.at("b")->end(seconds(0)).has_value());
  // It is tried again until the address is free.
  other.signal(SIGTERM);
  end("a");
  const auto it_leads = [&] { return run("declare '(relation more ((n integer)) (key n) (durable))'").status == 0; };
  EXPECT_TRUE(wait_until(it_leads, seconds(60))) << said();
}

TEST_F(UpWithLogHere, IsRefusedWithWhatWouldKeepABoardFromTakingOver) {
  const auto refusal = [&](const std::string& options) {
    const Said said = shell_in_scratch(std::string(PIZARRA_CELL) + " up " + cell_ + " --log " + log() + options);
    EXPECT_EQ(said.status, 2) << options;
    return said.text;
  };
  const std::string elsewhere = refusal(" --host b --standby tcp://127.0.0.1:1");
  EXPECT_TRUE(elsewhere.contains("no client would look for a board at --standby tcp://127.0.0.1:1: the cell file has " +
                                 board_ + "," + standby_))
      << elsewhere;
  const std::string own = refusal(" --host a --standby " + standby_);
  EXPECT_TRUE(own.contains("--standby is for another host than that of the cell's board")) << own;
  const std::string keys = refusal(" --host b --standby " + standby_ + " --keys " + scratch_folder() + "no-keys");
  EXPECT_TRUE(keys.contains("the board has no key of its own there")) << keys;
  const std::string past = refusal(" --host c --past " + scratch_folder() + "past");
  EXPECT_TRUE(past.contains("--past is for a host with a board, and c has none")) << past;
}

TEST_F(UpWithLogHere, BringsAMemberBackWhoseDataIsGone) {
  begin_log();
  end("c");
  std::filesystem::remove_all(scratch_folder() + "member-c");
  up("c", {});
  ASSERT_TRUE(wait_until([&] { return is_healthy("c"); }, seconds(60))) << said();
  // Without another member, the log has its quorum by this one.
  end("a");
  EXPECT_TRUE(comes("ask '(note ?n)'", "?n = 1")) << said();
  EXPECT_EQ(run("tell '(note 2)'").status, 0) << said();
}

TEST_F(UpWithLogHere, WaitsForTheOthersWhereAMemberHasLostItsData) {
  begin_log();
  for (const char* host : {"a", "b", "c"}) end(host);
  std::filesystem::remove_all(scratch_folder() + "member-c");
  up("c", {});
  // `up` tells it once the member has given up for now. The member says it at once.
  const std::string of_member = scratch_folder() + "pizarra/here@c/log.log";
  const auto waits_aloud = [&] { return whole_file(of_member).contains("member-c has no data, and waits for "); };
  ASSERT_TRUE(wait_until(waits_aloud, seconds(60))) << said();
  // With this one alone it has no majority that remembers.
  up("b", {"--standby", standby_});
  EXPECT_FALSE(wait_until([&] { return is_healthy("c"); }, seconds(3))) << said();
  up("a", {});
  EXPECT_TRUE(comes("ask '(note ?n)'", "?n = 1")) << said();
  EXPECT_TRUE(wait_until([&] { return is_healthy("c"); }, seconds(60))) << said();
}

// Of one host, with a log of one member: its command line, and where its past is.
TEST_F(UpWithLogHere, KeepsAPastOfLittleSpaceInTheRunsFolderAndALargeOneWhereItIsTold) {
  const std::string past = scratch_folder() + "the past";
  std::filesystem::remove_all(past);
  const auto board = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {PIZARRA_CELL,
                                      "up",
                                      cell_,
                                      "--host",
                                      "a",
                                      "--log",
                                      fmt::format("etcd://{}/here", members_.at("a")),
                                      "--log-here",
                                      members_.at("a"),
                                      "--log-folder",
                                      scratch_folder() + "member-a"};
    words.insert(words.end(), more.begin(), more.end());
    running_["a"] = std::make_unique<Running>(words, scratch_folder() + "up-a.log");
    EXPECT_TRUE(comes("ask '(agent robot ?kind ?host)'", "?host = \"a\"")) << said();
    std::string line = shell_in_scratch("pgrep -af 'pizarra-board.*" + board_ + "'").text;
    end("a");
    return line;
  };
  const std::string small = board({});
  EXPECT_TRUE(small.contains("/past --history-size 64MB")) << small;
  const std::string large = board({"--past", past});
  EXPECT_TRUE(large.contains("--past " + past) && !large.contains("--history-size")) << large;
  EXPECT_FALSE(std::filesystem::is_empty(past));
}

TEST_F(UpWithLogHere, IsRefusedForAnAddressThatIsNoMember) {
  const Said refused = shell_in_scratch(std::string(PIZARRA_CELL) + " up " + cell_ + " --host a --log " + log() +
                                        " --log-here 127.0.0.1:1 --log-folder " + scratch_folder() + "none");
  EXPECT_NE(refused.status, 0);
  EXPECT_TRUE(refused.text.contains("127.0.0.1:1 is no member of")) << refused.text;
  const Said half = shell_in_scratch(std::string(PIZARRA_CELL) + " log member 'etcd://[fd00::1]/cell' '[fd00' " +
                                     scratch_folder() + "none --log-insecure");
  EXPECT_EQ(half.status, 2) << half.text;
  EXPECT_TRUE(half.text.contains("[fd00 is no member of")) << half.text;
}

TEST_F(UpWithLogHere, IsRefusedForWhatIsNoLogAlsoWhereAHostHasAgentsAlone) {
  const Said refused = shell_in_scratch(std::string(PIZARRA_CELL) + " up " + cell_ + " --host c --log banana");
  EXPECT_EQ(refused.status, 2) << refused.text;
  EXPECT_TRUE(refused.text.contains("a log's address is etcd://A,B,C/CELL")) << refused.text;
}

}  // namespace
}  // namespace pizarra::programs
