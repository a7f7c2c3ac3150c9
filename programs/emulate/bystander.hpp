#pragma once

// The actions of a person beside a device, a line each on standard input: each is answered with how the device is.
//
//   Bystander bystander(executor, {.obey = ..., .status = ...});

#include <functional>
#include <string>

#include "blackboard/time/latch.hpp"
#include "lisp/result.hpp"

namespace pizarra::programs {

struct BesideDevice {
  std::function<Result<void>(std::string_view)> obey;
  std::function<Task<std::string>()> status;  // a line
};

class Bystander {
 public:
  Bystander(Executor& executor, BesideDevice device);
  ~Bystander();
  Bystander(const Bystander&) = delete;
  Bystander& operator=(const Bystander&) = delete;

 private:
  static constexpr std::size_t longest_line = 4096;
  static constexpr std::size_t most_lines = 256;
  void hear();
  Task<void> act();

  Executor& executor_;
  BesideDevice device_;
  std::string heard_;
  Queue<std::string> lines_;
  Job acting_;
};

}  // namespace pizarra::programs
