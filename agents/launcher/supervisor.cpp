#include "agents/launcher/supervisor.hpp"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include "agents/launcher/process_log.hpp"

namespace pizarra::launcher {

namespace {

sigset_t supervised_signals() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  sigaddset(&set, SIGTERM);
  sigaddset(&set, SIGHUP);
  sigaddset(&set, SIGPIPE);
  sigaddset(&set, SIGCHLD);
  return set;
}

// Between fork and exec, where only async-signal-safe calls may be made: everything was prepared before.
[[noreturn]] void become(const char* file, char* const* arguments, int log, int niceness, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(127);
  // A group of its own: Ctrl-C reaches the supervisor, which then stops the children in order.
  setpgid(0, 0);
  nice(niceness);
  const sigset_t none = [] {
    sigset_t set;
    sigemptyset(&set);
    return set;
  }();
  sigprocmask(SIG_SETMASK, &none, nullptr);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  close_range(3, ~0U, 0);
  execv(file, arguments);
  _exit(127);
}

std::string describe_status(int status) {
  if (WIFSIGNALED(status)) return fmt::format("killed by signal {}", WTERMSIG(status));
  return fmt::format("ended with status {}", WEXITSTATUS(status));
}

}  // namespace

Supervisor::Supervisor(Executor& executor, std::function<void(const ProcessEvent&)> tell)
    : executor_(executor), tell_(std::move(tell)) {
  const sigset_t set = supervised_signals();
  sigprocmask(SIG_BLOCK, &set, nullptr);
  signals_ = signalfd(-1, &set, SFD_NONBLOCK | SFD_CLOEXEC);
  assert(signals_ >= 0);
  executor_.watch_readable(signals_, [this] { on_signal(); });
}

Supervisor::~Supervisor() {
  executor_.unwatch_readable(signals_);
  close(signals_);
  if (kill_timer_ != 0) executor_.cancel(kill_timer_);
  for (Child& child : children_) {
    if (child.timer != 0) executor_.cancel(child.timer);
    if (child.pid == 0) continue;
    kill(child.pid, SIGKILL);
    waitpid(child.pid, nullptr, 0);
  }
}

void Supervisor::tell(Child& child, std::string sentence) {
  child.newest = sentence;
  if (tell_) tell_(ProcessEvent{child.program.name, std::move(sentence), child.given_up, child.pid == 0});
}

Result<void> Supervisor::spawn(Child& child) {
  const Result<int> log = open_process_log(child.program.log_file);
  if (!log) return fail(log);
  std::vector<char*> arguments;
  for (std::string& word : child.program.command) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) become(arguments.front(), arguments.data(), *log, child.program.niceness, parent);
  close(*log);
  if (pid < 0)
    return fail("cannot-start", fmt::format("cannot start {}: {}", child.program.name, std::strerror(errno)));
  child.pid = pid;
  child.started = executor_.now();
  tell(child, fmt::format("started as process {}", pid));
  return {};
}

Result<void> Supervisor::start(Program program) {
  assert(!program.command.empty());
  if (children_.size() >= most_programs) {
    return fail("too-many", fmt::format("no more than {} programs run under one supervisor", most_programs));
  }
  if (access(program.command.front().c_str(), X_OK) != 0) {
    return fail("cannot-start", fmt::format("{} cannot be run", program.command.front()));
  }
  Child child;
  child.program = std::move(program);
  const Result<void> spawned = spawn(child);
  if (!spawned) return spawned;
  children_.push_back(std::move(child));
  return {};
}

void Supervisor::on_signal() {
  signalfd_siginfo info;
  bool end = false;
  while (read(signals_, &info, sizeof info) == sizeof info) {
    if (info.ssi_signo != SIGCHLD) end = true;
  }
  reap();
  if (end) stop();
}

void Supervisor::reap() {
  for (Child& child : children_) {
    int status = 0;
    if (child.pid == 0 || waitpid(child.pid, &status, WNOHANG) != child.pid) continue;
    child.pid = 0;
    on_death(child, status);
  }
}

void Supervisor::on_death(Child& child, int status) {
  if (stopping_) return;
  if (WIFEXITED(status) && std::ranges::count(child.program.final_statuses, WEXITSTATUS(status)) > 0) {
    child.given_up = true;
    tell(child, describe_status(status) + "; to start it again would not help");
    return;
  }
  if (executor_.now() - child.started > steady_after) child.deaths = 0;
  start_again(child, describe_status(status));
}

// One that cannot be started, as while the disk is full, may be started later.
void Supervisor::start_again(Child& child, const std::string& why) {
  ++child.deaths;
  if (child.program.may_be_given_up && child.deaths >= most_deaths_in_a_row) {
    child.given_up = true;
    tell(child, fmt::format("{}; failed {} times in a row and is given up, see {}", why, most_deaths_in_a_row,
                            child.program.log_file));
    return;
  }
  const auto doubled = first_pause * (1 << std::min(child.deaths - 1, 10));
  const Duration pause = std::min<Duration>(doubled, longest_pause);
  const double pause_s = static_cast<double>(pause.count()) / 1e6;
  tell(child, fmt::format("{}; starts again in {} s", why, pause_s));
  const std::size_t index = static_cast<std::size_t>(&child - children_.data());
  child.timer = executor_.call_at(executor_.now() + pause, [this, index] {
    Child& again = children_[index];
    again.timer = 0;
    ++again.restarts;
    const Result<void> spawned = spawn(again);
    if (!spawned) start_again(again, spawned.error().sentence);
  });
}

void Supervisor::stop() {
  if (stopping_) return;
  stopping_ = true;
  for (Child& child : children_) {
    if (child.timer != 0) executor_.cancel(child.timer);
    child.timer = 0;
    if (child.pid != 0) kill(child.pid, SIGTERM);
  }
  kill_timer_ = executor_.call_at(executor_.now() + patience, [this] {
    kill_timer_ = 0;
    for (const Child& child : children_) {
      if (child.pid != 0) kill(child.pid, SIGKILL);
    }
  });
}

bool Supervisor::stopped() const {
  return stopping_ && std::ranges::all_of(children_, [](const Child& child) { return child.pid == 0; });
}

std::vector<Supervisor::Process> Supervisor::processes() const {
  std::vector<Process> out;
  for (const Child& child : children_) {
    out.push_back({child.program.name, child.pid, child.restarts, child.newest, child.given_up});
  }
  return out;
}

}  // namespace pizarra::launcher
