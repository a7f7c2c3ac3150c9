#include "tests/bench/child.hpp"

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>
#include <utility>

namespace pizarra::bench {

namespace {

constexpr int patience_ms = 60'000;

[[noreturn]] void give_up(const char* what) { throw std::system_error(errno, std::generic_category(), what); }

// Forks; both sides know their end of the socket pair.
std::pair<pid_t, int> split() {
  int ends[2];
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) give_up("socketpair");
  const pid_t parent = getpid();
  const pid_t process = fork();
  if (process < 0) give_up("fork");
  close(ends[process == 0 ? 0 : 1]);
  if (process == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // The parent may have died before it was asked for.
    if (getppid() != parent) _exit(1);
  }
  return {process, ends[process == 0 ? 1 : 0]};
}

}  // namespace

Pipe::Pipe(Pipe&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

Pipe::~Pipe() {
  if (file_ >= 0) close(file_);
}

void Pipe::say(double value) {
  if (write(file_, &value, sizeof value) != sizeof value) give_up("a child's parent is gone");
}

double Pipe::hear() {
  double value = 0;
  read_some(&value, sizeof value);
  return value;
}

std::string Pipe::hear_line() {
  std::string line;
  for (char c = 0; c != '\n';) {
    read_some(&c, 1);
    if (c != '\n') line += c;
  }
  return line;
}

void Pipe::read_some(void* into, std::size_t size) {
  pollfd waiting{file_, POLLIN, 0};
  if (poll(&waiting, 1, patience_ms) != 1) throw std::runtime_error("a process of the bench says nothing");
  if (read(file_, into, size) != static_cast<ssize_t>(size)) throw std::runtime_error("a process of the bench ended");
}

Child Child::running(const std::function<void(Pipe& parent)>& work) {
  const auto [process, file] = split();
  if (process != 0) return {process, file};
  Pipe parent(file);
  try {
    work(parent);
  } catch (const std::exception& error) {
    fprintf(stderr, "a process of the bench: %s\n", error.what());
  }
  // Nothing of the parent is to be destroyed twice.
  _exit(0);
}

Child Child::program(const std::vector<std::string>& command) {
  const auto [process, file] = split();
  if (process != 0) return {process, file};
  dup2(file, STDOUT_FILENO);
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  execv(arguments[0], arguments.data());
  _exit(127);
}

Child::Child(Child&& other) noexcept : process_(std::exchange(other.process_, 0)), pipe_(std::move(other.pipe_)) {}

Child::~Child() {
  if (process_ == 0) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void Child::signal(int number) const { kill(process_, number); }

bool Child::ended() const {
  siginfo_t news{};
  return waitid(P_PID, static_cast<id_t>(process_), &news, WEXITED | WNOHANG | WNOWAIT) == 0 && news.si_pid == process_;
}

double Child::memory_mb(const std::string& name) const {
  std::ifstream status("/proc/" + std::to_string(process_) + "/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with(name + ":")) return std::stod(line.substr(name.size() + 1)) / 1024;
  }
  return 0;
}

double Child::cpu_s() const {
  clockid_t clock{};
  timespec ran{};
  const bool is_known = clock_getcpuclockid(process_, &clock) == 0 && clock_gettime(clock, &ran) == 0;
  return is_known ? static_cast<double>(ran.tv_sec) + 1e-9 * static_cast<double>(ran.tv_nsec) : 0;
}

double Child::waited_for_core_ms() const {
  double waited_ns = 0;
  for (const auto& thread : std::filesystem::directory_iterator("/proc/" + std::to_string(process_) + "/task")) {
    double ran_ns = 0;
    double ready_ns = 0;
    std::ifstream(thread.path() / "schedstat") >> ran_ns >> ready_ns;
    waited_ns += ready_ns;
  }
  return 1e-6 * waited_ns;
}

TemporaryFolder::TemporaryFolder() : path_(std::filesystem::temp_directory_path() / "pizarra-bench-XXXXXX") {
  if (mkdtemp(path_.data()) == nullptr) throw std::system_error(errno, std::generic_category(), "mkdtemp");
}

TemporaryFolder::~TemporaryFolder() {
  if (!path_.empty()) std::filesystem::remove_all(path_);
}

std::string program_beside(const std::string& name) {
  return std::filesystem::read_symlink("/proc/self/exe").parent_path() / name;
}

}  // namespace pizarra::bench
