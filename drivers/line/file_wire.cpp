#include "drivers/line/file_wire.hpp"

#include <cerrno>
#include <sys/socket.h>
#include <system_error>
#include <unistd.h>

namespace pizarra::line {

std::string system_error() { return std::generic_category().message(errno); }

void FileWire::adopt(int file) {
  close();
  file_ = file;
  unread_.clear();
  unsent_.clear();
  executor_.watch_readable(file_, [this] { receive(); });
}

void FileWire::close() { lose("the line is closed"); }

void FileWire::lose(std::string why) {
  if (file_ < 0) return;
  executor_.unwatch_readable(file_);
  ::close(std::exchange(file_, -1));
  why_closed_ = std::move(why);
  arrived_.wake_all();
}

Result<void> FileWire::write(std::string_view bytes) {
  if (!bytes.empty() && !unsent_.empty()) {
    std::string_view rest = unsent_;
    const Result<void> ended = put(rest);
    unsent_.erase(0, unsent_.size() - rest.size());
    if (!ended) return ended;
  }
  const std::size_t whole = bytes.size();
  Result<void> done = put(bytes);
  if (!done && bytes.size() < whole) unsent_ = bytes;
  return done;
}

// Takes what was sent off the front.
Result<void> FileWire::put(std::string_view& bytes) {
  while (file_ >= 0 && !bytes.empty()) {
    // A socket whose other end is gone would end the program with a signal; other files know no flags.
    ssize_t sent = ::send(file_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno == ENOTSOCK) sent = ::write(file_, bytes.data(), bytes.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return fail("disconnected", "the line takes nothing: " + system_error());
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
  if (file_ < 0) return fail("disconnected", why_closed_);
  return {};
}

void FileWire::receive() {
  char chunk[4096];
  const ssize_t count = ::read(file_, chunk, sizeof chunk);
  if (count < 0 && (errno == EAGAIN || errno == EINTR)) return;
  if (count < 0) return lose("the line broke: " + system_error());
  if (count == 0) return lose("the other end closed the line");
  if (unread_.size() + static_cast<std::size_t>(count) > most_unread) return lose("more came than was read");
  unread_.append(chunk, static_cast<std::size_t>(count));
  arrived_.wake_all();
}

Task<Result<std::string>> FileWire::read(Time deadline) {
  while (unread_.empty() && file_ >= 0) {
    const bool woken = co_await arrived_.wait(deadline);
    if (!woken) co_return fail("timeout", "nothing came over the line in time");
  }
  if (unread_.empty()) co_return fail("disconnected", why_closed_);
  co_return std::exchange(unread_, {});
}

}  // namespace pizarra::line
