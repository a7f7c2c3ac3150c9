#pragma once

// A file that is open and is to be found again by its path: whether it is there still, or was moved or removed since,
// or another stands in its place.
//
//   const OpenFile journal("cell.journal");       // once it is open: what is there now is it
//   if (!journal.is_there()) ...
//   if (!journal.is_there(bytes)) ...              // or has fewer bytes than were written to it
//
// Where nothing is at first, nothing is missed.

#include <cstdint>
#include <optional>
#include <string>
#include <sys/types.h>
#include <utility>

namespace pizarra::journal {

class OpenFile {
 public:
  explicit OpenFile(std::string path);
  bool is_there(std::int64_t least_bytes = 0) const;
  // That it has now.
  std::int64_t bytes() const;

 private:
  using Identity = std::pair<dev_t, ino_t>;

  const std::string path_;
  std::optional<Identity> file_;
};

}  // namespace pizarra::journal
