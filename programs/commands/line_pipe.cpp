#include "programs/commands/line_pipe.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pizarra::programs {

Result<std::unique_ptr<LinePipe>> LinePipe::make(Executor& executor, const std::string& path, Heard heard) {
  ::unlink(path.c_str());
  const bool made = ::mkfifo(path.c_str(), 0600) == 0;
  // Open for writing too, so that it does not end when a writer does.
  const int file = made ? ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC) : -1;
  if (file < 0) return fail("cannot-start", fmt::format("{} cannot be made: {}", path, std::strerror(errno)));
  return std::unique_ptr<LinePipe>(new LinePipe(executor, path, file, std::move(heard)));
}

LinePipe::LinePipe(Executor& executor, std::string path, int file, Heard heard)
    : executor_(executor), path_(std::move(path)), file_(file), heard_(std::move(heard)) {
  executor_.watch_readable(file_, [this] { read(); });
}

LinePipe::~LinePipe() {
  executor_.unwatch_readable(file_);
  ::close(file_);
  ::unlink(path_.c_str());
}

void LinePipe::read() {
  char bytes[longest_line];
  const ssize_t got = ::read(file_, bytes, sizeof bytes);
  if (got <= 0) return;
  begun_.append(bytes, static_cast<std::size_t>(got));
  for (std::size_t end = begun_.find('\n'); end != std::string::npos; end = begun_.find('\n')) {
    heard_(begun_.substr(0, end));
    begun_.erase(0, end + 1);
  }
  if (begun_.size() > longest_line) begun_.clear();
}

Result<void> add_line(const std::string& path, const std::string& line) {
  const auto refused = [&path] { return fail("cannot-write", fmt::format("{}: {}", path, std::strerror(errno))); };
  const int file = ::open(path.c_str(), O_WRONLY | O_APPEND | O_CREAT | O_NONBLOCK | O_CLOEXEC, 0600);
  // A pipe that nobody reads.
  if (file < 0 && errno == ENXIO) return {};
  if (file < 0) return refused();
  const std::string whole = line + "\n";
  const ssize_t written = ::write(file, whole.data(), whole.size());
  const bool unread = written < 0 && errno == EAGAIN;
  Result<void> done = written < 0 && !unread ? Result<void>(refused()) : Result<void>();
  ::close(file);
  return done;
}

}  // namespace pizarra::programs
