#pragma once

// A program as a child of a test, and what it prints. It is killed when the test is done with it.
//
//   ChildProgram board({PIZARRA_BOARD_PROGRAM, "--listen", address});
//   board.line();                     // "pizarra-board: ready on ..."
//   EXPECT_EQ(board.stop(SIGTERM), 0);

#include <csignal>
#include <fstream>
#include <gtest/gtest.h>
#include <spawn.h>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "tests/whole_file.hpp"

namespace pizarra {

class ChildProgram {
 public:
  explicit ChildProgram(std::vector<std::string> words) {
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDERR_FILENO);
    posix_spawn_file_actions_addclose(&actions, ends[0]);
    EXPECT_EQ(posix_spawnp(&child_, arguments.front(), &actions, nullptr, arguments.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    output_ = ends[0];
  }
  ChildProgram(const ChildProgram&) = delete;
  ChildProgram& operator=(const ChildProgram&) = delete;
  ~ChildProgram() {
    if (child_ != 0) stop(SIGKILL);
    close(output_);
  }

  // The next line it prints; what there is when it ends.
  std::string line() {
    std::string line;
    for (char c = 0; read_char(c) && c != '\n';) line += c;
    return line;
  }
  std::string rest() {
    std::string rest;
    for (char c = 0; read_char(c);) rest += c;
    return rest;
  }
  // Every file that its memory shows: the program and the libraries it runs with.
  std::string mapped_files() const { return whole_file("/proc/" + std::to_string(child_) + "/maps"); }
  double resident_mb() const {
    std::ifstream status("/proc/" + std::to_string(child_) + "/status");
    for (std::string line; std::getline(status, line);) {
      if (line.starts_with("VmRSS:")) return std::stod(line.substr(6)) / 1024;
    }
    return 0;
  }
  // Its exit code, or minus the signal that ended it.
  int stop(int signal) {
    send(signal);
    return wait();
  }
  void send(int signal) const { kill(child_, signal); }
  // Whether it has ended by itself; wait() then has its exit code.
  bool ended() const {
    siginfo_t news{};
    return waitid(P_PID, static_cast<id_t>(child_), &news, WEXITED | WNOHANG | WNOWAIT) == 0 && news.si_pid == child_;
  }
  int wait() {
    int status = 0;
    waitpid(child_, &status, 0);
    child_ = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  }

 private:
  bool read_char(char& c) const { return ::read(output_, &c, 1) == 1; }
  pid_t child_ = 0;
  int output_ = -1;
};

}  // namespace pizarra
