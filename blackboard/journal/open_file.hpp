#pragma once

// A file that is open and is to be found again by its path: whether it is there still, or was moved or removed since, or
// another stands in its place.
//
//   const OpenFile journal("cell.journal");       // once it is open: what is there now is it
//   if (!journal.is_there()) ...
//
// Where nothing is at first, nothing is missed.

#include <optional>
#include <string>
#include <sys/types.h>
#include <utility>

namespace pizarra {

class OpenFile {
 public:
  explicit OpenFile(std::string path);
  bool is_there() const { return !file_ || at(path_) == file_; }

 private:
  using Identity = std::pair<dev_t, ino_t>;
  static std::optional<Identity> at(const std::string& path);

  const std::string path_;
  const std::optional<Identity> file_;
};

}  // namespace pizarra
