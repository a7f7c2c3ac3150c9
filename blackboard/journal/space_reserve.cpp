#include "blackboard/journal/space_reserve.hpp"

#include <fcntl.h>
#include <unistd.h>
#include <utility>

namespace pizarra {

bool SpaceReserve::fill() {
  if (filled_) return true;
  const int file = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  if (file < 0) return false;
  filled_ = posix_fallocate(file, 0, bytes) == 0;
  close(file);
  if (!filled_) unlink(path_.c_str());
  return filled_;
}

bool SpaceReserve::spend() {
  if (!std::exchange(filled_, false)) return false;
  return unlink(path_.c_str()) == 0;
}

}  // namespace pizarra
