#include "blackboard/journal/space_reserve.hpp"

#include <algorithm>
#include <utility>

namespace pizarra::journal {

std::int64_t SpaceReserve::fill() {
  if (2 * bytes_ > most) return bytes_;
  // What stands there is of a former life.
  if (bytes_ == 0) disk_.remove(path_);
  const std::unique_ptr<Disk::File> file = disk_.open(path_, Disk::Access::write);
  if (file == nullptr) return bytes_;
  const std::int64_t before = bytes_;
  std::int64_t wanted = std::clamp((file->free_bytes() + before) / 2, least, most);
  // The disk may report more space than this user may have.
  while (bytes_ == before && wanted >= 2 * before) {
    if (file->set_aside(wanted)) {
      bytes_ = wanted;
    } else if (wanted == least) {
      break;
    }
    wanted = std::max(wanted / 2, least);
  }
  if (bytes_ == 0) disk_.remove(path_);
  return bytes_;
}

bool SpaceReserve::spend() {
  if (std::exchange(bytes_, 0) == 0) return false;
  return disk_.remove(path_);
}

}  // namespace pizarra::journal
