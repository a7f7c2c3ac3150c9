#include "blackboard/journal/space_reserve.hpp"

#include <algorithm>
#include <fcntl.h>
#include <sys/statvfs.h>
#include <unistd.h>
#include <utility>

namespace pizarra::journal {

namespace {

std::int64_t free_bytes(int file) {
  struct statvfs disk {};
  if (fstatvfs(file, &disk) != 0) return 0;
  return static_cast<std::int64_t>(disk.f_bavail) * static_cast<std::int64_t>(disk.f_frsize);
}

}  // namespace

std::int64_t SpaceReserve::fill() {
  if (2 * bytes_ > most) return bytes_;
  const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | (bytes_ == 0 ? O_TRUNC : 0), 0600);
  if (file < 0) return bytes_;
  const std::int64_t before = bytes_;
  std::int64_t wanted = std::clamp((free_bytes(file) + before) / 2, least, most);
  // What the disk says that it has may be more than one may have of it.
  while (bytes_ == before && wanted >= 2 * before) {
    if (posix_fallocate(file, 0, wanted) == 0) {
      bytes_ = wanted;
    } else if (ftruncate(file, before) != 0 || wanted == least) {
      break;
    }
    wanted = std::max(wanted / 2, least);
  }
  close(file);
  if (bytes_ == 0) unlink(path_.c_str());
  return bytes_;
}

bool SpaceReserve::spend() {
  if (std::exchange(bytes_, 0) == 0) return false;
  return unlink(path_.c_str()) == 0;
}

}  // namespace pizarra::journal
