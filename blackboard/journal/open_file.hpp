#pragma once

// A file that is open and is to be found again by its path: whether it is there still, or was moved or removed since,
// or another stands in its place.
//
//   const OpenFile journal(disk, "cell.journal");       // once it is open: what is there now is it
//   if (!journal.is_there()) ...
//   if (!journal.is_there(bytes)) ...              // or has fewer bytes than were written to it
//
// Where no file was there when this was made, is_there() stays true.

#include <cstdint>
#include <optional>
#include <string>

#include "blackboard/journal/disk.hpp"

namespace pizarra::journal {

class OpenFile {
 public:
  OpenFile(const Disk& disk, std::string path);
  bool is_there(std::int64_t least_bytes = 0) const;
  // That it has now.
  std::int64_t bytes() const;

 private:
  const Disk& disk_;
  const std::string path_;
  std::optional<Disk::Identity> file_;
};

}  // namespace pizarra::journal
