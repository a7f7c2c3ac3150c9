#pragma once

// Space set aside on a disk that may become full, so that what was begun can still be ended.
//
//   SpaceReserve reserve("cell.journal-reserve");
//   reserve.fill();              // whether it is there now
//   reserve.spend();             // whether there was any; the disk has that much more now
//
// The file goes with it.

#include <string>

namespace pizarra {

class SpaceReserve {
 public:
  static constexpr long bytes = 1 << 20;

  explicit SpaceReserve(std::string path) : path_(std::move(path)) {}
  SpaceReserve(const SpaceReserve&) = delete;
  SpaceReserve& operator=(const SpaceReserve&) = delete;
  ~SpaceReserve() { spend(); }

  bool fill();
  bool spend();

 private:
  const std::string path_;
  bool filled_ = false;
};

}  // namespace pizarra
