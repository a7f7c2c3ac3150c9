#pragma once

// The supervisor keeps a cell's processes running: it starts them, starts again one that dies, later each time it dies
// soon, and stops them all in the end. Children die with it, whatever happens to it.
//
// Lifecycle: made before any thread of the process (it blocks SIGINT, SIGTERM and SIGCHLD for all of them), start() for
// each program, then the executor runs; stop() or a signal begins the end, and stopped() says when no child is left.
//
//   Supervisor supervisor(executor, [](const ProcessEvent& event) { ... });
//   supervisor.start({"vision", {"/usr/bin/pizarra-agent", "agent", "vision"}, "/run/.../vision.log"});
//   executor.run_until([&] { return supervisor.stopped(); });

#include <functional>
#include <string>
#include <sys/types.h>
#include <vector>

#include "blackboard/time/executor.hpp"
#include "lisp/result.hpp"

namespace pizarra::launcher {

struct Program {
  std::string name;
  std::vector<std::string> command;      // the first is the file to run
  std::string log_file;                  // what it prints
  std::vector<int> final_statuses = {};  // it does not start again when it ends with one of these
  int niceness = 0;                      // beyond our own, up to 19: the nicer, the more the others go first
  bool may_be_given_up = true;           // where it dies again and again
};

struct ProcessEvent {
  std::string name;
  std::string sentence;   // "started as process 4711", "killed by signal 9; starts again in 0.5 s"
  bool given_up = false;  // it does not start again
  bool ended = false;     // by itself, or it could not be started
};

class Supervisor {
 public:
  static constexpr Duration first_pause = 250ms;
  static constexpr Duration longest_pause = 8s;
  static constexpr Duration steady_after = 20s;  // who lives this long is forgiven its earlier deaths
  static constexpr int most_deaths_in_a_row = 12;
  static constexpr Duration patience = 3s;  // between SIGTERM and SIGKILL
  static constexpr std::size_t most_programs = 32;

  struct Process {
    std::string name;
    pid_t pid = 0;  // 0: not running
    int restarts = 0;
    std::string newest = {};  // the sentence of its last event
    bool given_up = false;    // it does not start again
  };

  Supervisor(Executor& executor, std::function<void(const ProcessEvent&)> tell);
  // Kills what still runs.
  ~Supervisor();
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  // Failures: cannot-start, too-many.
  Result<void> start(Program program);
  void stop();
  bool stopping() const { return stopping_; }
  bool stopped() const;
  std::vector<Process> processes() const;

 private:
  struct Child {
    Program program;
    pid_t pid = 0;
    Time started{};
    int deaths = 0;
    int restarts = 0;
    Executor::TimerId timer = 0;
    bool given_up = false;
    std::string newest = {};
  };

  void on_signal();
  void reap();
  void on_death(Child& child, int status);
  void start_again(Child& child, const std::string& why);
  Result<void> spawn(Child& child);
  void tell(Child& child, std::string sentence);

  Executor& executor_;
  std::function<void(const ProcessEvent&)> tell_;
  int signals_ = -1;
  std::vector<Child> children_;
  bool stopping_ = false;
  Executor::TimerId kill_timer_ = 0;
};

}  // namespace pizarra::launcher
