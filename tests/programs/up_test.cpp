// A cell as processes around a board: one is killed while a goal is built, and the goal is reached all the same.

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

constexpr std::chrono::milliseconds look_pause{200};
constexpr std::chrono::seconds patience{60};

class UpTest : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(bell_) << "(operation (ring) 1)\n";
    std::ofstream(cell_) << "(cell pair (world (cube circle (at 450 -60)) (cube triangle (at 450 60))) (domain \""
                         << source_dir() << "/domains/blocks.scm\") (agent bell (scheme \"" << bell_ << "\")))\n";
    up_ = fork();
    if (up_ == 0) {
      const int log = creat((folder_ + "up.log").c_str(), 0600);
      dup2(log, STDOUT_FILENO);
      dup2(log, STDERR_FILENO);
      execl(PIZARRA_CELL, PIZARRA_CELL, "up", cell_.c_str(), nullptr);
      _exit(127);
    }
  }
  void TearDown() override {
    if (up_ > 0) {
      kill(up_, SIGKILL);
      waitpid(up_, nullptr, 0);
    }
  }

  Said run(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1"); }
  bool wait_for(const std::string& words, const std::string& wanted) {
    const auto end = std::chrono::steady_clock::now() + patience;
    while (std::chrono::steady_clock::now() < end) {
      if (run(words).text.find(wanted) != std::string::npos) return true;
      std::this_thread::sleep_for(look_pause);
    }
    return false;
  }
  pid_t pid_of(const std::string& process) {
    const std::string text = run("ps --json").text;
    const std::size_t line = text.find("\"name\":\"" + process + "\"");
    const std::size_t pid = text.find("\"pid\":", line);
    return line == std::string::npos ? 0 : static_cast<pid_t>(std::strtol(text.c_str() + pid + 6, nullptr, 10));
  }
  std::string log() { return whole_file(folder_ + "up.log"); }

  const std::string folder_ = scratch_folder();
  const std::string cell_ = folder_ + "cell.scm";
  const std::string bell_ = folder_ + "bell.scm";
  pid_t up_ = 0;
};

TEST_F(UpTest, AGoalIsReachedAlthoughAnAgentIsKilledAndNothingIsLeftBehind) {
  ASSERT_TRUE(wait_for("ask '(person done ?what)'", "?what = ")) << log();
  EXPECT_EQ(run("ask '(board-refusal \"narrator\" ?symbol ? ?)'").text, "no\n");
  const std::string picture = folder_ + "eyes.png";
  const Said looked = run("look colour --frames 3 --png " + picture);
  EXPECT_EQ(looked.status, 0) << looked.text;
  EXPECT_NE(looked.text.find("320 x 240 colour"), std::string::npos) << looked.text;
  EXPECT_TRUE(std::filesystem::exists(picture));
  EXPECT_NE(run("look").text.find("vision-annotated     annotated"), std::string::npos);
  EXPECT_EQ(run("look sideways").status, 1);
  const Said busy = run("top --once");
  EXPECT_EQ(busy.status, 0) << busy.text;
  for (const char* shown : {"a fact is committed after ", "AGENT", "planner", "RELATION"}) {
    EXPECT_NE(busy.text.find(shown), std::string::npos) << shown << "\n" << busy.text;
  }
  EXPECT_TRUE(run("top --once --json").text.starts_with("{\"revision\":"));
  Said goal{-1, ""};
  std::thread asker([&] { goal = run("repl --eval '(goal (on circle triangle))'"); });
  const bool begun = wait_for("ask '(operation ?n ?what running)'", "PICK-UP");
  const pid_t robot = pid_of("robot");
  const bool killed = robot > 0 && kill(robot, SIGKILL) == 0;
  asker.join();
  EXPECT_TRUE(begun && killed) << log();
  EXPECT_EQ(goal.status, 0) << goal.text << log();
  EXPECT_NE(pid_of("robot"), robot);

  const pid_t vision = pid_of("vision");
  kill(up_, SIGTERM);
  int status = 0;
  waitpid(up_, &status, 0);
  up_ = 0;
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  EXPECT_NE(kill(vision, 0), 0);
  EXPECT_EQ(run("ps").text, "no cell runs here\n");
}

TEST_F(UpTest, TheLauncherBindsItsAgentsAndUnbindsWhatHasEndedForGood) {
  const std::string names = "repl --eval '(list (cell hosts localhost))'";
  for (const char* name : {"  robot: robot (robot)\n", "  vision: vision (vision)\n", "  planner: planner (planner)\n",
                           "  coordinator: coordinator (coordinator)\n", "  bell: bell (bell)\n"}) {
    EXPECT_TRUE(wait_for(names, name)) << run(names).text << log();
  }
  const pid_t planner = pid_of("planner");
  ASSERT_EQ(kill(planner, SIGKILL), 0);
  EXPECT_TRUE(wait_for("ps --json", "\"name\":\"planner\"")) << log();
  EXPECT_EQ(run("repl --eval '(resolve (cell hosts localhost planner))'").text, "planner (planner)\n");
  // An agent whose file is gone is not started again.
  std::filesystem::remove(bell_);
  ASSERT_EQ(kill(pid_of("bell"), SIGKILL), 0);
  const std::string bell = "repl --eval '(resolve (cell hosts localhost bell))'";
  EXPECT_TRUE(wait_for(bell, "nothing is bound as cell/hosts/localhost/bell")) << run(bell).text << log();
  EXPECT_NE(run(names).text.find("robot: robot (robot)"), std::string::npos);
}

TEST_F(UpTest, TheChildrenDieWithASupervisorThatIsKilled) {
  ASSERT_TRUE(wait_for("ps", "vision"));
  const pid_t vision = pid_of("vision");
  ASSERT_GT(vision, 0);
  kill(up_, SIGKILL);
  waitpid(up_, nullptr, 0);
  up_ = 0;
  const auto end = std::chrono::steady_clock::now() + patience;
  while (kill(vision, 0) == 0 && std::chrono::steady_clock::now() < end) std::this_thread::sleep_for(look_pause);
  EXPECT_NE(kill(vision, 0), 0);
}

}  // namespace
}  // namespace pizarra::programs
