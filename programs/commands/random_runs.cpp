#include "programs/commands/random_runs.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fmt/format.h>
#include <map>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "lisp/json.hpp"
#include "programs/command_line/exit_codes.hpp"
#include "programs/story/random_run.hpp"

namespace pizarra::programs {

namespace {

constexpr std::size_t longest_line = 2000;

volatile std::sig_atomic_t interrupted = 0;
void on_interrupt(int) { interrupted = 1; }

struct Worker {
  std::uint64_t seed;
  pid_t pid;
  int pipe;
  std::chrono::steady_clock::time_point started;
  std::string text;
  bool timed_out = false;
};

class Pool {
 public:
  explicit Pool(const RandomRuns& runs) : runs_(runs) {
    const unsigned cores = std::max(1U, std::thread::hardware_concurrency());
    jobs_ = runs.jobs == 0 ? cores : runs.jobs;
  }
  int run();

 private:
  bool start(std::uint64_t seed);
  void read_some();
  void collect(Worker& worker);
  void print_ready();
  void kill_all();
  void print_summary();

  const RandomRuns& runs_;
  std::size_t jobs_ = 1;
  std::vector<Worker> workers_;
  std::map<std::uint64_t, story::RandomResult> results_;
  std::uint64_t next_to_print_ = 0;
  std::map<story::RandomResult::Kind, int> counts_;
  std::string unreadable_;
};

[[noreturn]] void be_worker(const RandomRuns& runs, std::uint64_t seed, int pipe, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  // Ctrl-C comes to all of a terminal's processes; the one that counts ends the others.
  std::signal(SIGINT, SIG_IGN);
  std::signal(SIGTERM, SIG_DFL);
  const story::RandomResult result = story::run_random_seed(runs.cell_file, runs.arm, seed);
  const std::string text = fmt::format("{}{}", static_cast<int>(result.kind), result.line).substr(0, longest_line);
  const bool written = ::write(pipe, text.data(), text.size()) == static_cast<ssize_t>(text.size());
  _exit(written ? 0 : 1);
}

bool Pool::start(std::uint64_t seed) {
  int ends[2];
  if (pipe(ends) != 0) return false;
  std::fflush(nullptr);
  const pid_t parent = getpid();
  const pid_t pid = fork();
  if (pid == 0) {
    close(ends[0]);
    be_worker(runs_, seed, ends[1], parent);
  }
  close(ends[1]);
  if (pid < 0) {
    close(ends[0]);
    return false;
  }
  workers_.push_back({seed, pid, ends[0], std::chrono::steady_clock::now(), {}, false});
  return true;
}

void Pool::collect(Worker& worker) {
  close(worker.pipe);
  int status = 0;
  waitpid(worker.pid, &status, 0);
  story::RandomResult result;
  if (worker.timed_out) {
    result.kind = story::RandomResult::Kind::timed_out;
    result.line = fmt::format("no end within {} s of this machine's time", runs_.longest_run.count());
  } else if (WIFSIGNALED(status)) {
    result.line = fmt::format("ended by signal {}", WTERMSIG(status));
  } else if (WEXITSTATUS(status) != 0 || worker.text.empty()) {
    result.line = fmt::format("ended with status {} and no word", WEXITSTATUS(status));
  } else {
    result.kind = static_cast<story::RandomResult::Kind>(worker.text.front() - '0');
    result.line = worker.text.substr(1);
  }
  results_.emplace(worker.seed, std::move(result));
}

void Pool::read_some() {
  std::vector<pollfd> files;
  for (const Worker& worker : workers_) files.push_back({worker.pipe, POLLIN, 0});
  poll(files.data(), files.size(), 500);
  for (std::size_t i = workers_.size(); i-- > 0;) {
    Worker& worker = workers_[i];
    if (std::chrono::steady_clock::now() - worker.started > runs_.longest_run) {
      worker.timed_out = kill(worker.pid, SIGKILL) == 0;
    }
    if (files[i].revents == 0) continue;
    char buffer[512];
    const ssize_t got = read(worker.pipe, buffer, sizeof buffer);
    if (got > 0) {
      worker.text.append(buffer, static_cast<std::size_t>(got));
      continue;
    }
    collect(worker);
    workers_.erase(workers_.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

void Pool::print_ready() {
  static constexpr const char* words[] = {"reached", "refused", "failed", "timed out"};
  for (auto ready = results_.find(next_to_print_); ready != results_.end(); ready = results_.find(next_to_print_)) {
    const story::RandomResult& result = ready->second;
    if (result.kind == story::RandomResult::Kind::unreadable) {
      unreadable_ = result.line;
      return;
    }
    ++counts_[result.kind];
    const char* word = words[static_cast<int>(result.kind)];
    if (runs_.json) {
      fmt::print("{{\"seed\":{},\"result\":\"{}\",\"line\":{}}}\n", next_to_print_, word, json_string(result.line));
    } else {
      fmt::print("seed {:5}  {:<7}  {}\n", next_to_print_, word, result.line);
    }
    std::fflush(stdout);
    ++next_to_print_;
  }
}

void Pool::kill_all() {
  for (Worker& worker : workers_) {
    kill(worker.pid, SIGKILL);
    waitpid(worker.pid, nullptr, 0);
    close(worker.pipe);
  }
  workers_.clear();
}

// On standard error where the lines were not read any more.
void Pool::print_summary() {
  using Kind = story::RandomResult::Kind;
  const int reached = counts_[Kind::reached];
  const int refused = counts_[Kind::refused];
  const int failed = counts_[Kind::failed];
  const std::uint64_t done = next_to_print_ - runs_.first_seed;
  const int timed_out = counts_[Kind::timed_out];
  const bool cut_short = interrupted != 0;
  std::FILE* const out = std::ferror(stdout) == 0 ? stdout : stderr;
  if (runs_.json) {
    fmt::print(out, "{{\"reached\":{},\"refused_correctly\":{},\"failed\":{},\"timed_out\":{}{}}}\n", reached, refused,
               failed, timed_out, cut_short ? fmt::format(",\"interrupted_after\":{}", done) : "");
  } else {
    fmt::print(out, "reached {}, refused correctly {}, failed {}{}{}\n", reached, refused, failed,
               timed_out > 0 ? fmt::format(", timed out {}", timed_out) : "",
               cut_short ? fmt::format("; interrupted after {} of {} seeds", done, runs_.seeds) : "");
  }
}

int Pool::run() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
  sigaction(SIGPIPE, &action, nullptr);
  next_to_print_ = runs_.first_seed;
  std::uint64_t next = runs_.first_seed;
  const std::uint64_t end = runs_.first_seed + runs_.seeds;
  while ((next < end || !workers_.empty()) && interrupted == 0) {
    while (next < end && workers_.size() < jobs_) {
      if (!start(next)) {
        kill_all();
        fmt::print(stderr, "pizarra: cannot start another process\n");
        return exit_unavailable;
      }
      ++next;
    }
    read_some();
    print_ready();
    if (!unreadable_.empty()) {
      kill_all();
      fmt::print(stderr, "pizarra: {}\n", unreadable_);
      return exit_usage;
    }
  }
  kill_all();
  print_summary();
  if (interrupted != 0) return exit_interrupted;
  if (counts_[story::RandomResult::Kind::failed] > 0) return exit_failed;
  return counts_[story::RandomResult::Kind::timed_out] > 0 ? exit_unavailable : exit_reached;
}

}  // namespace

int run_random(const RandomRuns& runs) { return Pool(runs).run(); }

}  // namespace pizarra::programs
