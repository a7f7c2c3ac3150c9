// A cell's journal that is moved to an etcd and back, by the commands that people have for it.

#include <gtest/gtest.h>
#include <memory>

#include "blackboard/journal/journal_file.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/blackboard/cluster/real_etcd.hpp"
#include "tests/free_port.hpp"
#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"

namespace pizarra::programs {
namespace {

class LogCommands : public testing::Test {
 protected:
  void SetUp() override {
    if (!cluster::RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed (etcd-server)";
    for (const std::string& path : {file_, back_}) journal::remove_journal(path);
    etcd_ = std::make_unique<cluster::RealEtcd>();
    log_ = etcd_->address("moved");
    // It may take a while to listen.
    ASSERT_TRUE(wait_until([&] { return run("replay " + log_ + " --eval '(moment)'").text.contains("no log"); },
                           std::chrono::seconds(60)));
  }
  static Said run(const std::string& words) { return shell_in_scratch(std::string(PIZARRA_CELL) + " " + words); }
  // A board that keeps what it is told there, until it is ended.
  std::unique_ptr<ChildProgram> board(const std::string& option, const std::string& where) const {
    auto board =
        std::make_unique<ChildProgram>(std::vector<std::string>{PIZARRA_BOARD, "--listen", at_, option, where});
    for (std::string line = board->line(); !line.contains("ready on"); line = board->line()) {
      if (line.empty()) throw std::runtime_error("the board ended");
    }
    return board;
  }
  Said tell(const std::string& fact) const { return run("tell --board " + at_ + " '" + fact + "'"); }

  const std::string file_ = scratch_folder() + "moved.journal";
  const std::string back_ = scratch_folder() + "moved-back.journal";
  const std::string at_ = "ipc://" + scratch_folder() + "moved.ipc";
  std::string log_;
  std::unique_ptr<cluster::RealEtcd> etcd_;
};

TEST_F(LogCommands, MoveACellToAnEtcdAndBack) {
  {
    const auto alone = board("--journal", file_);
    ASSERT_EQ(run("declare --board " + at_ + " '(relation note ((n integer)) (key n) (durable))'").status, 0);
    ASSERT_EQ(tell("(note 1)").status, 0);
    const Said refused = run("log copy " + file_ + " " + log_);
    EXPECT_EQ(refused.status, 1) << refused.text;
    EXPECT_EQ(alone->stop(SIGTERM), 0);
  }
  const Said there = run("log copy " + file_ + " " + log_);
  EXPECT_EQ(there.status, 0) << there.text;
  EXPECT_TRUE(there.text.contains(": 1 durable facts, revision ")) << there.text;
  EXPECT_EQ(run("replay " + log_ + " --eval '(ask (note ?n))'").text, "?n = 1\n");
  EXPECT_EQ(run("log copy " + file_ + " " + log_).status, 1) << "it is there already";
  {
    const auto leading = board("--log", log_);
    ASSERT_EQ(tell("(note 2)").status, 0);
    const Said led = run("log copy " + log_ + " " + back_);
    EXPECT_EQ(led.status, 1);
    EXPECT_TRUE(led.text.contains("leads this cell: end its boards first")) << led.text;
    EXPECT_EQ(leading->stop(SIGTERM), 0);
  }
  const Said back = run("log copy " + log_ + " " + back_);
  EXPECT_EQ(back.status, 0) << back.text;
  EXPECT_EQ(run("ask --journal " + back_ + " '(note ?n)'").text, "?n = 1\n?n = 2\n");
  const auto alone = board("--journal", back_);
  EXPECT_EQ(run("ask --board " + at_ + " '(note ?n)'").text, "?n = 1\n?n = 2\n");
}

TEST_F(LogCommands, AskTheOtherMembersWhereTheFirstIsDown) {
  const auto leading = board("--log", log_);
  ASSERT_EQ(run("declare --board " + at_ + " '(relation note ((n integer)) (key n) (durable))'").status, 0);
  ASSERT_EQ(tell("(note 1)").status, 0);
  EXPECT_EQ(leading->stop(SIGTERM), 0);
  const std::string with_one_down =
      "etcd://127.0.0.1:" + std::to_string(free_port()) + "," + log_.substr(std::string("etcd://").size());
  EXPECT_EQ(run("replay " + with_one_down + " --eval '(ask (note ?n))'").text, "?n = 1\n");
  const Said copied = run("log copy " + with_one_down + " " + back_);
  EXPECT_EQ(copied.status, 0) << copied.text;
}

TEST_F(LogCommands, SayWhereTheLogLacksWhatIsAskedAbout) {
  const auto leading = board("--log", log_);
  ASSERT_EQ(run("declare --board " + at_ + " '(relation note ((n integer)) (key n) (durable))'").status, 0);
  ASSERT_EQ(run("declare --board " + at_ + " '(relation seen ((n integer)) (key n))'").status, 0);
  ASSERT_EQ(tell("(seen 1)").status, 0);
  ASSERT_EQ(tell("(note 1)").status, 0);
  EXPECT_EQ(leading->stop(SIGTERM), 0);
  EXPECT_EQ(run("replay " + log_ + " --eval '(ask (note ?n))'").text, "?n = 1\n");
  for (const char* form : {"(ask (seen ?n))", "(watch (seen ?n))", "(ask (and (note ?n) (seen ?n)))"}) {
    const Said said = run("replay " + log_ + " --eval '" + form + "'");
    EXPECT_EQ(said.status, 1) << said.text;
    EXPECT_TRUE(said.text.contains("has only what is durable")) << said.text;
  }
}

TEST_F(LogCommands, RefuseWhatTheyCannotCopy) {
  for (const std::string& both : {file_ + " " + back_, log_ + " " + log_}) {
    const Said said = run("log copy " + both);
    EXPECT_EQ(said.status, 2) << said.text;
    EXPECT_TRUE(said.text.contains("one of both is a file, and the other a log")) << said.text;
  }
  EXPECT_TRUE(run("log copy " + log_ + " " + back_).text.contains("the cluster has no log of this cell"));
  EXPECT_TRUE(run("log copy " + file_ + " " + log_).text.contains("there is no journal"));
  EXPECT_EQ(run("log copy etcd://10.0.0.1/cell " + back_).status, 2);
  EXPECT_EQ(run("log").status, 2);
}

}  // namespace
}  // namespace pizarra::programs
