#include "tests/programs/running.hpp"

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "tests/whole_file.hpp"

namespace pizarra::programs {

bool wait_until(const std::function<bool()>& condition, std::chrono::seconds how_long) {
  constexpr std::chrono::milliseconds look_pause{100};
  const auto end = std::chrono::steady_clock::now() + how_long;
  while (std::chrono::steady_clock::now() < end) {
    if (condition()) return true;
    std::this_thread::sleep_for(look_pause);
  }
  return condition();
}

Running::Running(std::vector<std::string> words, std::string log) : log_(std::move(log)) {
  std::filesystem::remove(log_);  // what another one said there is not this one's
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  pid_ = fork();
  if (pid_ != 0) return;
  const int out = open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  dup2(open("/dev/null", O_RDONLY), STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

Running::~Running() {
  if (status_) return;
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
}

void Running::signal(int number) const {
  if (!status_) kill(pid_, number);
}

std::optional<int> Running::end(std::chrono::seconds how_long) {
  wait_until([this] { return look(); }, how_long);
  return status_;
}

bool Running::look() {
  int status = 0;
  if (status_ || waitpid(pid_, &status, WNOHANG) != pid_) return status_.has_value();
  status_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  return true;
}

}  // namespace pizarra::programs
