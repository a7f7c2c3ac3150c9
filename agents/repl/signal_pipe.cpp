#include "agents/repl/signal_pipe.hpp"

#include <cassert>
#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace pizarra::repl {

namespace {

// All that a signal handler can reach.
volatile sig_atomic_t write_end = -1;

void note(int signal) {
  const int before = errno;
  const auto byte = static_cast<unsigned char>(signal);
  // A full pipe holds signals enough.
  [[maybe_unused]] const ssize_t written = ::write(write_end, &byte, 1);
  errno = before;
}

}  // namespace

SignalPipe::SignalPipe(const std::vector<int>& signals) {
  assert(write_end < 0 && "one at a time");
  int ends[2];
  [[maybe_unused]] const int made = pipe2(ends, O_NONBLOCK | O_CLOEXEC);
  assert(made == 0);
  read_end_ = ends[0];
  write_end = ends[1];
  struct sigaction action {};
  action.sa_handler = note;
  action.sa_flags = SA_RESTART;
  for (const int signal : signals) sigaction(signal, &action, &before_[signal]);
}

SignalPipe::~SignalPipe() {
  for (const auto& [signal, action] : before_) sigaction(signal, &action, nullptr);
  close(write_end);
  close(read_end_);
  write_end = -1;
}

std::vector<int> SignalPipe::take() {
  std::vector<int> out;
  unsigned char signal = 0;
  while (::read(read_end_, &signal, 1) == 1) out.push_back(signal);
  return out;
}

}  // namespace pizarra::repl
