#include "agents/launcher/run_directory.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/scratch.hpp"

namespace pizarra::launcher {
namespace {

class RunDirectoryTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = scratch_folder() + "runs";
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::string folder_;
};

RunState state_of(int pid, const std::string& board) {
  return {"blocks", "here", pid, board, "", "", "/cells/blocks.scm", {{"vision", 7, 1}}};
}

TEST_F(RunDirectoryTest, IsTheUsersAlone) {
  const Result<RunDirectory> run = RunDirectory::make("blocks", "here");
  ASSERT_TRUE(run) << describe(run.error());
  struct stat status {};
  ASSERT_EQ(stat(run->path().c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0700U);
}

TEST_F(RunDirectoryTest, AFolderThatOthersMayReadIsNotTrusted) {
  std::filesystem::create_directories(folder_ + "/pizarra");
  std::filesystem::permissions(folder_ + "/pizarra", std::filesystem::perms(0755));
  const Result<RunDirectory> run = RunDirectory::make("blocks", "here");
  ASSERT_FALSE(run);
  EXPECT_EQ(run.error().symbol, "cannot-write");
}

TEST_F(RunDirectoryTest, APathTooLongForASocketIsToldWithTheVariableToChange) {
  const std::string deep = folder_ + "/" + std::string(100, 'x');
  setenv("XDG_RUNTIME_DIR", deep.c_str(), 1);
  const Result<RunDirectory> run = RunDirectory::make("blocks", "here");
  ASSERT_FALSE(run);
  EXPECT_NE(run.error().sentence.find(deep + "/pizarra/blocks@here/board.ipc has "), std::string::npos);
  EXPECT_NE(run.error().sentence.find("XDG_RUNTIME_DIR"), std::string::npos);
}

TEST_F(RunDirectoryTest, TheLogsOfAnEarlierRunAreGoneWhenTheNextBeginsAndNotBefore) {
  const std::string log = RunDirectory::make("blocks", "here").value().file("board.log");
  std::ofstream(log) << "an earlier run\n";
  EXPECT_TRUE(running_cells().empty());
  EXPECT_TRUE(std::filesystem::exists(log));
  ASSERT_TRUE(RunDirectory::make("blocks", "here"));
  EXPECT_FALSE(std::filesystem::exists(log));
}

TEST_F(RunDirectoryTest, AStateIsReadBackAsItWasSaved) {
  const RunState state = state_of(getpid(), "ipc:///tmp/board");
  const Result<RunState> back = run_state_from_datum(run_state_to_datum(state));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->board_address, state.board_address);
  EXPECT_EQ(back->cell_file, state.cell_file);
  ASSERT_EQ(back->processes.size(), 1U);
  EXPECT_EQ(back->processes[0].pid, 7);
}

TEST_F(RunDirectoryTest, ARunningCellIsFoundAndNotStartedTwice) {
  const Result<RunDirectory> run = RunDirectory::make("blocks", "here");
  ASSERT_TRUE(run);
  ASSERT_TRUE(run->save(state_of(getpid(), "ipc:///tmp/board")));
  EXPECT_EQ(find_run("").value().board_address, "ipc:///tmp/board");
  EXPECT_EQ(find_run("blocks").value().supervisor_pid, getpid());
  EXPECT_EQ(find_run("other").error().symbol, "nothing-runs");
  EXPECT_EQ(RunDirectory::make("blocks", "here").error().symbol, "already-running");
}

TEST_F(RunDirectoryTest, WhatADeadSupervisorLeftIsNotARunningCellThoughAnotherProcessHasItsNumber) {
  const pid_t supervisor = fork();
  if (supervisor == 0) {
    const Result<RunDirectory> run = RunDirectory::make("blocks", "here");
    const bool saved = run.has_value() && run->save(state_of(getppid(), "ipc:///tmp/board"));
    if (saved) std::ofstream(run->file("world.ipc")) << "";
    if (saved) std::ofstream(run->file("vision.log")) << "what vision said";
    _exit(saved ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(supervisor, &status, 0), supervisor);
  ASSERT_EQ(status, 0);
  const std::string left = folder_ + "/pizarra/blocks@here/";
  ASSERT_TRUE(std::filesystem::exists(left + "state"));
  EXPECT_TRUE(running_cells().empty());
  EXPECT_FALSE(std::filesystem::exists(left + "state"));
  EXPECT_FALSE(std::filesystem::exists(left + "world.ipc"));
  EXPECT_TRUE(std::filesystem::exists(left + "vision.log"));
  EXPECT_TRUE(RunDirectory::make("blocks", "here"));
}

TEST_F(RunDirectoryTest, ACellThatHasYetToWriteItsStateIsNotStartedTwice) {
  const Result<RunDirectory> run = RunDirectory::make("blocks", "here");
  ASSERT_TRUE(run);
  EXPECT_EQ(RunDirectory::make("blocks", "here").error().symbol, "already-running");
}

}  // namespace
}  // namespace pizarra::launcher
