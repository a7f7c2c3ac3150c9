#pragma once

// A named pipe for lines that a process of ours says to this one alone. It is there, for its owner, while this lives.
//
//   auto pipe = LinePipe::make(executor, folder + "/addresses", [](const std::string& line) { ... });

#include <functional>
#include <memory>
#include <string>

#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"

namespace pizarra::programs {

class LinePipe {
 public:
  using Heard = std::function<void(const std::string& line)>;
  static constexpr std::size_t longest_line = 4096;  // what is longer is thrown away

  // Failure: cannot-start.
  static Result<std::unique_ptr<LinePipe>> make(Executor& executor, const std::string& path, Heard heard);
  LinePipe(const LinePipe&) = delete;
  LinePipe& operator=(const LinePipe&) = delete;
  ~LinePipe();

 private:
  LinePipe(Executor& executor, std::string path, int file, Heard heard);
  void read();

  Executor& executor_;
  const std::string path_;
  const int file_;
  Heard heard_;
  std::string begun_;
};

// Says a line to a pipe, or adds it to a file; to a pipe that nobody reads it says nothing. Failure cannot-write.
Result<void> add_line(const std::string& path, const std::string& line);

}  // namespace pizarra::programs
