#include "drivers/pddl_planner/process_keeper.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <dirent.h>
#include <fcntl.h>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/signalfd.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace pizarra::pddl_planner {

namespace {

// Children of children fall to us when their parents are killed, and so one round follows another; a program that
// forks faster than it is killed is left to its limits.
constexpr int most_rounds = 1000;

// The number behind the command's name, which stands in parentheses and may hold anything: `17 (a b) S 1 ...`.
pid_t parent_of(pid_t pid) {
  const int file = open(("/proc/" + std::to_string(pid) + "/stat").c_str(), O_RDONLY | O_CLOEXEC);
  std::array<char, 512> bytes;
  const ssize_t got = file < 0 ? 0 : read(file, bytes.data(), bytes.size());
  close(file);
  const std::string_view text(bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  const std::size_t name_end = text.rfind(')');
  pid_t parent = 0;
  if (name_end != text.npos && text.size() > name_end + 4) {
    std::from_chars(text.data() + name_end + 4, text.data() + text.size(), parent);
  }
  return parent;
}

std::vector<pid_t> children() {
  std::vector<pid_t> found;
  DIR* folder = opendir("/proc");
  while (const dirent* entry = folder == nullptr ? nullptr : readdir(folder)) {
    const pid_t pid = static_cast<pid_t>(std::strtol(entry->d_name, nullptr, 10));
    if (pid > 0 && parent_of(pid) == getpid()) found.push_back(pid);
  }
  if (folder != nullptr) closedir(folder);
  return found;
}

void end_all() {
  for (int round = 0; round < most_rounds; ++round) {
    std::vector<pid_t> left = children();
    std::erase_if(left, [](pid_t pid) { return kill(pid, SIGKILL) != 0; });
    if (left.empty()) return;
    for (const pid_t pid : left) waitpid(pid, nullptr, 0);
  }
}

// The program's status once it has ended; those that fell to us and ended are let go meanwhile.
bool has_ended(pid_t program, int& status) {
  int its_status = 0;
  for (pid_t ended = waitpid(-1, &its_status, WNOHANG); ended > 0; ended = waitpid(-1, &its_status, WNOHANG)) {
    if (ended != program) continue;
    status = its_status;
    return true;
  }
  return false;
}

[[noreturn]] void end_like(int status) {
  if (WIFSIGNALED(status)) {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_CORE, &none);
    signal(WTERMSIG(status), SIG_DFL);
    sigset_t nothing;
    sigemptyset(&nothing);
    sigprocmask(SIG_SETMASK, &nothing, nullptr);
    raise(WTERMSIG(status));
  }
  _exit(WEXITSTATUS(status));
}

}  // namespace

void keep(int life, const std::function<void()>& become) {
  sigset_t all;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, nullptr);
  signal(SIGCHLD, SIG_DFL);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  sigset_t child_ended;
  sigemptyset(&child_ended);
  sigaddset(&child_ended, SIGCHLD);
  const int ends = signalfd(-1, &child_ended, SFD_CLOEXEC | SFD_NONBLOCK);
  const pid_t program = fork();
  if (program == 0) become();
  int status = 127 << 8;
  std::array<pollfd, 2> watched{{{life, POLLIN, 0}, {ends, POLLIN, 0}}};
  while (program > 0 && !has_ended(program, status)) {
    poll(watched.data(), watched.size(), -1);
    if (watched[0].revents != 0) break;
    signalfd_siginfo ignored;
    while (read(ends, &ignored, sizeof(ignored)) > 0) continue;
  }
  end_all();
  end_like(status);
}

}  // namespace pizarra::pddl_planner
