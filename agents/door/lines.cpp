#include "agents/door/lines.hpp"

#include <cassert>
#include <cerrno>
#include <fmt/format.h>
#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

namespace pizarra::door {

namespace {

constexpr Duration longest_goodbye = 1s;
constexpr std::string_view line_ends = "\r\n";

bool comes_later() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

Lines::Lines(Executor& executor, int file)
    : executor_(executor), file_(file), poll_(epoll_create1(EPOLL_CLOEXEC)), changed_(executor) {
  assert(poll_ >= 0);
  executor_.watch_readable(poll_, [this] { run(); });
  look_for_more();
}

Lines::~Lines() {
  executor_.unwatch_readable(poll_);
  ::close(poll_);
  ::close(file_);
}

Task<Result<std::string>> Lines::next(std::optional<Time> deadline) {
  while (true) {
    if (interrupted_) {
      Failure why = std::move(*interrupted_);
      interrupted_.reset();
      co_return fail(std::move(why));
    }
    std::optional<std::string> line = take_line();
    if (line) co_return std::move(*line);
    if (unread_.size() > longest) {
      pass_over_line();
      co_return fail("too-long", fmt::format("a line has {} bytes at most", longest));
    }
    if (over()) co_return fail("disconnected", "the other side has gone");
    const bool woken = co_await changed_.wait(deadline);
    if (!woken) co_return fail("timeout", "nothing was said in time");
  }
}

std::optional<std::string> Lines::take_line() {
  unread_.erase(0, unread_.find_first_not_of(line_ends));
  const std::size_t end = unread_.find_first_of(line_ends);
  std::optional<std::string> line;
  if (end != std::string::npos && end <= longest) {
    line = unread_.substr(0, end);
    unread_.erase(0, end + 1);
  }
  look_for_more();
  return line;
}

void Lines::pass_over_line() {
  const std::size_t end = unread_.find_first_of(line_ends);
  passing_over_ = end == std::string::npos;
  unread_.erase(0, end);
  look_for_more();
}

Task<bool> Lines::room() {
  while (unsent_.size() >= most_unsent && !broken_ && !interrupted_) {
    co_await changed_.wait();
  }
  co_return !broken_ && !interrupted_;
}

void Lines::say(std::string_view line) {
  if (broken_) return;
  const bool idle = unsent_.empty();
  unsent_ += line;
  unsent_ += '\n';
  if (idle) transmit();
  look_for_more();
}

void Lines::interrupt(Failure why) {
  interrupted_ = std::move(why);
  changed_.wake_all();
}

Task<void> Lines::finish() {
  const Time deadline = executor_.now() + longest_goodbye;
  bool in_time = true;
  while (!unsent_.empty() && !broken_ && in_time) {
    in_time = co_await changed_.wait(deadline);
  }
  ::shutdown(file_, SHUT_WR);
  throwing_away_ = true;
  unread_.clear();
  look_for_more();
  while (!over() && in_time) {
    in_time = co_await changed_.wait(deadline);
  }
}

void Lines::run() {
  if (!unsent_.empty()) transmit();
  if ((wanted_ & EPOLLIN) != 0) receive();
  look_for_more();
  changed_.wake_all();
}

void Lines::receive() {
  char chunk[longest];
  const ssize_t count = ::read(file_, chunk, sizeof chunk);
  if (count < 0 && comes_later()) return;
  ended_ = count == 0;
  broken_ = count < 0;
  if (count <= 0 || throwing_away_) return;
  std::string_view come(chunk, static_cast<std::size_t>(count));
  if (passing_over_) {
    const std::size_t end = come.find_first_of(line_ends);
    if (end == std::string_view::npos) return;
    passing_over_ = false;
    come.remove_prefix(end);
  }
  unread_ += come;
}

void Lines::transmit() {
  while (!unsent_.empty()) {
    // A socket whose other end is gone would end the program with a signal; other files know no flags.
    ssize_t sent = ::send(file_, unsent_.data(), unsent_.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == ENOTSOCK) sent = ::write(file_, unsent_.data(), unsent_.size());
    if (sent < 0 && comes_later()) return;
    if (sent < 0) {
      broken_ = true;
      unsent_.clear();
      return;
    }
    unsent_.erase(0, static_cast<std::size_t>(sent));
  }
}

// A file that nothing is wanted of is let go: that its other end has gone would be told again and again.
void Lines::look_for_more() {
  unsigned wanted = 0;
  if (!over() && (throwing_away_ || unread_.size() <= longest)) wanted |= EPOLLIN;
  if (!broken_ && !unsent_.empty()) wanted |= EPOLLOUT;
  if (wanted == wanted_) return;
  epoll_event event{.events = wanted, .data = {}};
  const int change = wanted_ == 0 ? EPOLL_CTL_ADD : wanted == 0 ? EPOLL_CTL_DEL : EPOLL_CTL_MOD;
  epoll_ctl(poll_, change, file_, &event);
  wanted_ = wanted;
}

}  // namespace pizarra::door
