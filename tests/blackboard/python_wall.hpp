#pragma once

// The walls to Python's clients (blackboard/python): boards whose every call is made by a python3 process that is
// spoken to through pipes. Plain, or of asyncio.
//
//   PythonProcess python(executor, PythonProcess::Kind::plain);
//   std::unique_ptr<Board> board = python.view("tcp://127.0.0.1:7800", "alice");

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <sys/types.h>

#include "blackboard/board.hpp"
#include "blackboard/time/executor.hpp"

namespace pizarra {

class PythonProcess {
 public:
  using Done = std::function<void(Result<Datum>)>;

  enum class Kind { plain, asyncio };
  PythonProcess(Executor& executor, Kind kind);
  PythonProcess(const PythonProcess&) = delete;
  PythonProcess& operator=(const PythonProcess&) = delete;
  ~PythonProcess();

  std::unique_ptr<Board> view(const std::string& address, const std::string& teller, Duration timeout = 5s);

  Executor& executor() { return executor_; }
  std::int64_t next_number() { return next_number_++; }
  // Has `view` perform (OPERATION ARGUMENT ...); `done` may be empty.
  std::int64_t begin(std::int64_t view, const Datum& operation, Done done);
  void forget(std::int64_t request) { pending_.erase(request); }
  Task<Result<Datum>> call(std::int64_t view, Datum operation);

 private:
  void receive();
  void say(const std::string& line) const;

  Executor& executor_;
  pid_t child_ = 0;
  int to_child_ = -1;
  int from_child_ = -1;
  std::int64_t next_number_ = 1;
  std::map<std::int64_t, Done> pending_;
  std::string unread_;
};

// By the name of a test's parameter: "python" is the plain one.
inline PythonProcess::Kind python_kind(const std::string& client) {
  return client == "asyncio" ? PythonProcess::Kind::asyncio : PythonProcess::Kind::plain;
}

}  // namespace pizarra
