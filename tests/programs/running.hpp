#pragma once

// A program that runs while the test goes on; what it says goes to a file. Killed when destroyed.
//
//   Running up({PIZARRA_CELL, "up", cell}, scratch_folder() + "up.log");
//   up.signal(SIGINT);
//   EXPECT_EQ(up.end(seconds(10)), 0) << up.said();

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "tests/whole_file.hpp"

namespace pizarra::programs {

// Whether the condition comes to hold.
bool wait_until(const std::function<bool()>& condition, std::chrono::seconds how_long);

class Running {
 public:
  // The first word is the program's file. It has an empty standard input.
  Running(std::vector<std::string> words, std::string log);
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running();

  void signal(int number) const;
  // Its exit status, minus the signal that killed it, or nothing while it runs on.
  std::optional<int> end(std::chrono::seconds how_long);
  std::string said() const { return whole_file(log_); }

 private:
  bool look();

  std::string log_;
  pid_t pid_ = 0;
  std::optional<int> status_;
};

}  // namespace pizarra::programs
