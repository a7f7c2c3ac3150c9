#pragma once

// How far a journal is known to be on the disk, said in a small file beside it. SQLite takes the first damaged page of
// its log for the end of it, and says nothing of what came after; the mark does.
//
//   KeptMark mark(disk, "cell.journal-kept");
//   mark.set(17);                    // once the disk has entry 17; it is not waited for itself
//   mark.get();                      // never more than the disk has been said to have; nothing where nobody knows

#include <cstdint>
#include <optional>
#include <string>

#include "blackboard/journal/disk.hpp"

namespace pizarra::journal {

class KeptMark {
 public:
  KeptMark(Disk& disk, std::string path) : disk_(disk), path_(std::move(path)) {}
  KeptMark(const KeptMark&) = delete;
  KeptMark& operator=(const KeptMark&) = delete;

  const std::string& path() const { return path_; }
  std::optional<std::int64_t> get() const;
  // What cannot be said is left as it was.
  void set(std::int64_t entry);

 private:
  Disk& disk_;
  const std::string path_;
  std::unique_ptr<Disk::File> file_;  // once it was written
};

}  // namespace pizarra::journal
