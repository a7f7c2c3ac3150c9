#pragma once

// Space set aside on a disk that may become full, so that what was begun can still be ended.
//
//   SpaceReserve reserve(disk, "cell.journal-reserve");
//   reserve.fill();              // how many bytes are set aside now, if any
//   reserve.spend();             // whether there were any; the disk has that much more now
//
// It takes half of what the disk has at most, and grows with it. The file goes with it.

#include <cstdint>
#include <string>

#include "blackboard/journal/disk.hpp"

namespace pizarra::journal {

class SpaceReserve {
 public:
  static constexpr std::int64_t least = 256 << 10;
  static constexpr std::int64_t most = 16 << 20;

  SpaceReserve(Disk& disk, std::string path) : disk_(disk), path_(std::move(path)) {}
  SpaceReserve(const SpaceReserve&) = delete;
  SpaceReserve& operator=(const SpaceReserve&) = delete;
  ~SpaceReserve() { spend(); }

  std::int64_t fill();
  bool spend();

 private:
  Disk& disk_;
  const std::string path_;
  std::int64_t bytes_ = 0;
};

}  // namespace pizarra::journal
