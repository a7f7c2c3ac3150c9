#include "drivers/pddl_planner/planner_process.hpp"

#include <array>
#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/timerfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include "drivers/pddl_planner/process_keeper.hpp"

namespace pizarra::pddl_planner {

namespace {

constexpr int between_looks_ms = 20;

void limit(int resource, rlim_t most) {
  const rlimit bound{most, most};
  setrlimit(static_cast<__rlimit_resource_t>(resource), &bound);
}

[[noreturn]] void become(const char* command, const char* folder, const ProcessLimits& limits, int output) {
  setpgid(0, 0);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const bool ready = chdir(folder) == 0 && dup2(nothing, STDIN_FILENO) >= 0 && dup2(output, STDOUT_FILENO) >= 0 &&
                     dup2(output, STDERR_FILENO) >= 0;
  limit(RLIMIT_AS, limits.memory_bytes);
  limit(RLIMIT_CPU, static_cast<rlim_t>(std::ceil(limits.seconds)) + 1);
  limit(RLIMIT_FSIZE, limits.file_bytes);
  limit(RLIMIT_CORE, 0);
  if (ready) execl("/bin/sh", "sh", "-c", command, nullptr);
  _exit(127);
}

// A timer to poll, which the kernel counts.
int timer_of(double seconds) {
  const double whole = std::floor(seconds);
  itimerspec once{};
  once.it_value.tv_sec = static_cast<time_t>(whole);
  once.it_value.tv_nsec = static_cast<long>((seconds - whole) * 1e9);
  const int timer = timerfd_create(CLOCK_MONOTONIC, TFD_CLOEXEC);
  timerfd_settime(timer, 0, &once, nullptr);
  return timer;
}

// The keeper of the running process, the reading end of what that prints, and its timer; everything ends with this.
class Running {
 public:
  Running(pid_t keeper, int life, int output, double seconds)
      : keeper_(keeper), life_(life), output_(output), timer_(timer_of(seconds)) {}
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running() {
    close(life_);
    if (!ended_) waitpid(keeper_, nullptr, 0);
    close(output_);
    close(timer_);
  }

  // Waits a moment for output or the end.
  void look(std::string& output, std::size_t most) {
    std::array<pollfd, 2> watched{{{at_end_ ? -1 : output_, POLLIN, 0}, {timer_, POLLIN, 0}}};
    poll(watched.data(), watched.size(), between_looks_ms);
    timed_out_ = (watched[1].revents & POLLIN) != 0;
    read_what_is_there(output, most);
    if (!ended_ && waitpid(keeper_, &status_, WNOHANG) == keeper_) ended_ = true;
    if (ended_) read_what_is_there(output, most);
  }

  bool ended() const { return ended_; }
  bool timed_out() const { return timed_out_; }
  int status() const { return status_; }

 private:
  void read_what_is_there(std::string& output, std::size_t most) {
    std::array<char, 65536> part;
    while (!at_end_ && output.size() <= most) {
      const ssize_t got = read(output_, part.data(), part.size());
      if (got < 0) return;
      at_end_ = got == 0;
      output.append(part.data(), static_cast<std::size_t>(got));
    }
  }

  pid_t keeper_;
  int life_;
  int output_;
  int timer_;
  int status_ = 0;
  bool ended_ = false;
  bool timed_out_ = false;
  bool at_end_ = false;
};

ProcessEnd watch(Running& process, const ProcessLimits& limits, const std::function<bool()>& cancelled) {
  ProcessEnd end;
  while (true) {
    process.look(end.output, limits.output_bytes);
    if (end.output.size() > limits.output_bytes) {
      end.kind = ProcessEnd::Kind::too_much_output;
    } else if (process.ended() && WIFEXITED(process.status())) {
      end.kind = ProcessEnd::Kind::exited;
      end.code = WEXITSTATUS(process.status());
    } else if (process.ended()) {
      end.kind = ProcessEnd::Kind::signalled;
      end.code = WTERMSIG(process.status());
    } else if (cancelled()) {
      end.kind = ProcessEnd::Kind::cancelled;
    } else if (process.timed_out()) {
      end.kind = ProcessEnd::Kind::timed_out;
    } else {
      continue;
    }
    return end;
  }
}

void close_both(const std::array<int, 2>& ends) {
  close(ends[0]);
  close(ends[1]);
}

}  // namespace

ProcessEnd run_process(const std::string& command, const std::string& folder, const ProcessLimits& limits,
                       const std::function<bool()>& cancelled) {
  std::array<int, 2> printed, life;
  if (pipe2(printed.data(), O_CLOEXEC) != 0) return {};
  if (pipe2(life.data(), O_CLOEXEC) != 0) {
    close_both(printed);
    return {};
  }
  fcntl(printed[0], F_SETFL, O_NONBLOCK);
  const pid_t keeper = fork();
  if (keeper == 0) {
    setpgid(0, 0);  // away from what Ctrl-C ends
    close(life[1]);
    keep(life[0], [&] { become(command.c_str(), folder.c_str(), limits, printed[1]); });
  }
  if (keeper < 0) {
    close_both(printed);
    close_both(life);
    return {};
  }
  close(printed[1]);
  close(life[0]);
  Running process(keeper, life[1], printed[0], limits.seconds);
  return watch(process, limits, cancelled);
}

}  // namespace pizarra::pddl_planner
