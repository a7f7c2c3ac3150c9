#include "programs/story/seed_pool.hpp"

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace pizarra::story {

namespace {

volatile std::sig_atomic_t signalled = 0;
void on_signal(int) { signalled = 1; }

void hear_signals() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) sigaction(signal, &action, nullptr);
}

[[noreturn]] void be_worker(const SeedPool::Work& work, std::uint64_t seed, int pipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  // Ctrl-C comes to all of a terminal's processes; the one that counts ends the others.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
  const std::string text = work(seed);
  std::size_t written = 0;
  while (written < text.size()) {
    const ssize_t some = ::write(pipe, text.data() + written, text.size() - written);
    if (some <= 0) _exit(1);
    written += static_cast<std::size_t>(some);
  }
  _exit(0);
}

}  // namespace

SeedPool::SeedPool(Seeds seeds, Work work) : seeds_(seeds), work_(std::move(work)) {
  const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
  jobs_ = seeds_.jobs == 0 ? cores : seeds_.jobs;
}

bool SeedPool::start(std::uint64_t seed) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    close(ends[0]);
    be_worker(work_, seed, ends[1], parent);
  }
  close(ends[1]);
  if (pid < 0) {
    close(ends[0]);
    return false;
  }
  workers_.push_back({seed, pid, ends[0], std::chrono::steady_clock::now(), {}, false});
  return true;
}

void SeedPool::collect(Worker& worker) {
  close(worker.pipe);
  int status = 0;
  waitpid(worker.pid, &status, 0);
  Answer answer{worker.text, {}, worker.overdue};
  if (worker.overdue) {
    answer.trouble = fmt::format("no end within {} s of this machine's time", seeds_.longest.count());
  } else if (WIFSIGNALED(status)) {
    answer.trouble = fmt::format("ended by signal {}", WTERMSIG(status));
  } else if (WEXITSTATUS(status) != 0 || worker.text.empty()) {
    answer.trouble = fmt::format("ended with status {} and no word", WEXITSTATUS(status));
  }
  if (!answer.trouble.empty()) answer.text.clear();
  answers_.emplace(worker.seed, std::move(answer));
}

void SeedPool::read_some() {
  constexpr int patience_ms = 500;
  std::vector<pollfd> files;
  for (const Worker& worker : workers_) files.push_back({worker.pipe, POLLIN, 0});
  poll(files.data(), files.size(), patience_ms);
  for (std::size_t i = workers_.size(); i-- > 0;) {
    Worker& worker = workers_[i];
    if (std::chrono::steady_clock::now() - worker.started > seeds_.longest) {
      worker.overdue = kill(worker.pid, SIGKILL) == 0;
    }
    if (files[i].revents == 0) continue;
    char buffer[4096];
    const ssize_t got = read(worker.pipe, buffer, sizeof buffer);
    if (got > 0) {
      worker.text.append(buffer, static_cast<std::size_t>(got));
      continue;
    }
    collect(worker);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void SeedPool::end_all() {
  for (Worker& worker : workers_) {
    kill(worker.pid, SIGKILL);
    waitpid(worker.pid, nullptr, 0);
    close(worker.pipe);
  }
  workers_.clear();
}

SeedPool::End SeedPool::run(const Hear& hear) {
  hear_signals();
  std::uint64_t next = seeds_.first;
  std::uint64_t heard = seeds_.first;
  const std::uint64_t end = seeds_.first + seeds_.seeds;
  bool goes_on = true;
  while (heard < end && goes_on && signalled == 0) {
    while (next < end && workers_.size() < jobs_) {
      if (!start(next)) {
        end_all();
        return End::no_process;
      }
      ++next;
    }
    read_some();
    for (auto next_one = answers_.find(heard); goes_on && next_one != answers_.end(); next_one = answers_.find(heard)) {
      goes_on = hear(heard++, next_one->second);
      answers_.erase(next_one);
    }
  }
  end_all();
  return signalled == 0 ? End::heard : End::interrupted;
}

}  // namespace pizarra::story
