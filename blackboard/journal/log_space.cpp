#include "blackboard/journal/log_space.hpp"

#include <array>
#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>

namespace pizarra::journal {

namespace {

// A thousand pages, after which SQLite copies them to where they belong, and those of the transaction that is the last.
constexpr off_t wanted = 1032 * off_t{4096 + 24};
constexpr std::int64_t of_what_is_free = 64;

bool has_plenty(int file) {
  struct statvfs disk {};
  if (fstatvfs(file, &disk) != 0) return false;
  return static_cast<std::int64_t>(disk.f_bavail) * static_cast<std::int64_t>(disk.f_frsize) / of_what_is_free > wanted;
}

}  // namespace

void write_log_ahead(const std::string& path) {
  const int file = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return;
  static constexpr std::array<char, 64 << 10> nothing{};
  off_t end = has_plenty(file) ? lseek(file, 0, SEEK_END) : wanted;
  while (end < wanted && pwrite(file, nothing.data(), nothing.size(), end) == ssize_t{nothing.size()}) {
    end += static_cast<off_t>(nothing.size());
  }
  close(file);
}

}  // namespace pizarra::journal
