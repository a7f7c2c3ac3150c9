// A board whose journal is on a file system of four megabytes that becomes full.

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sched.h>
#include <sys/mount.h>

#include "blackboard/client/remote_board.hpp"
#include "blackboard/time/real_executor.hpp"
#include "tests/blackboard/board_fixture.hpp"
#include "tests/blackboard/child_program.hpp"
#include "tests/scratch.hpp"

namespace pizarra {
namespace {

class FullDiskTest : public testing::Test, public Wall {
 protected:
  // In a view of the file systems that this process and its children have alone, and that ends with them.
  void SetUp() override {
    std::filesystem::create_directory(disk_);
    const bool mounted = unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
                         mount("tmpfs", disk_.c_str(), "tmpfs", 0, "size=4m") == 0;
    if (!mounted) GTEST_SKIP() << "a file system is root's to mount";
  }
  void TearDown() override {
    board_.reset();
    umount(disk_.c_str());
  }
  void start() {
    board_.emplace(std::vector<std::string>{PIZARRA_BOARD_PROGRAM, "--listen", address_, "--journal",
                                            disk_ + "/board.journal", "--history", "0"});
    ASSERT_TRUE(board_->line().starts_with("pizarra-board: ready"));
    alice_ = view("alice");
  }
  Executor& executor() override { return executor_; }
  std::unique_ptr<Board> view(const std::string& teller) override {
    return RemoteBoard::connect(executor_, address_, teller).value();
  }
  Result<Revision> tell(const std::string& relation, int n) {
    return run(alice_->tell(list(Datum::symbol(relation), n, std::string(20'000, 'x'))));
  }
  std::size_t goals() { return run(alice_->facts(read("(goal ? ?)")))->size(); }

  const std::string disk_ = scratch_folder() + "disk";
  const std::string address_ = ipc_address();
  RealExecutor executor_;
  std::optional<ChildProgram> board_;
  std::unique_ptr<Board> alice_;
};

TEST_F(FullDiskTest, WhatIsDurableIsRefusedByNameReadsGoOnAndWithSpaceItIsWrittenAgain) {
  start();
  ASSERT_EQ(symbol_of(run(alice_->declare({relation("(relation goal ((n integer) (text string)) (key n) (durable))"),
                                           relation("(relation note ((n integer) (text string)) (key n))")}))),
            "ok");
  ASSERT_EQ(symbol_of(tell("goal", 1)), "ok");
  // Somebody else takes what is left.
  std::ofstream other(disk_ + "/other", std::ios::binary);
  const std::string block(4096, 'y');
  while (other.write(block.data(), static_cast<std::streamsize>(block.size())) && other.flush()) {
  }
  other.close();
  int last = 1;
  Result<Revision> told = tell("goal", last + 1);
  for (; told && last < 400; told = tell("goal", last + 1)) ++last;
  ASSERT_FALSE(told.has_value());
  EXPECT_EQ(told.error().symbol, "journal-full") << told.error().sentence;
  EXPECT_NE(told.error().sentence.find("board.journal"), std::string::npos) << told.error().sentence;
  EXPECT_EQ(goals() >= static_cast<std::size_t>(last), true) << "reading goes on";
  EXPECT_EQ(symbol_of(tell("note", 1)), "ok") << "what need not last goes on";
  std::filesystem::remove(disk_ + "/other");
  const Time freed = executor_.now();
  while (!told && executor_.now() < freed + 5s) {
    pass(50ms);
    told = tell("goal", last + 1);
  }
  ASSERT_TRUE(told.has_value()) << told.error().sentence;
  EXPECT_LT(executor_.now() - freed, 2s);
  // All that was acknowledged is there after it was killed.
  EXPECT_EQ(board_->stop(SIGKILL), -SIGKILL);
  start();
  EXPECT_GE(goals(), static_cast<std::size_t>(last + 1));
}

}  // namespace
}  // namespace pizarra
