#pragma once

// The disk that a journal is kept on: SQLite's files, by the name of a VFS, and what a journal asks of a disk beside
// them. There are two: this machine's, and one that a test simulates (simulated/simulated_disk.hpp).
//
//   Disk& disk = this_disk();
//   const Result<std::unique_ptr<Disk::Lock>> lock = disk.lock("cell.journal");    // for as long as that lives
//   const std::unique_ptr<Disk::File> mark = disk.open("cell.journal-kept", Disk::Access::write);
//   if (mark != nullptr) mark->write_at(0, "17");

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "lisp/result.hpp"

namespace pizarra::journal {

class Disk {
 public:
  // One that can be opened no more is the same file as long as both numbers agree.
  using Identity = std::pair<std::uint64_t, std::uint64_t>;
  struct Status {
    Identity file;
    std::int64_t bytes = 0;
  };
  enum class Access : std::uint8_t { read, write };  // write makes the file where there is none

  class Lock {
   public:
    virtual ~Lock() = default;
  };

  class File {
   public:
    virtual ~File() = default;
    virtual std::int64_t bytes() const = 0;
    // From its beginning.
    virtual std::string read(std::size_t most) const = 0;
    // Whether all of it was written.
    virtual bool write_at(std::int64_t offset, std::string_view text) = 0;
    // So many bytes, for which the disk then has space; false, and as it was, where it has not.
    virtual bool set_aside(std::int64_t bytes) = 0;
    // That the disk it is on has left.
    virtual std::int64_t free_bytes() const = 0;
  };

  virtual ~Disk() = default;

  // SQLite's name for it; null: SQLite's own choice.
  virtual const char* vfs() const = 0;
  // Nothing where no file is.
  virtual std::optional<Status> status(const std::string& path) const = 0;
  // Null where it cannot be opened.
  virtual std::unique_ptr<File> open(const std::string& path, Access access) = 0;
  // Makes the file where there is none. Failure journal-file.
  virtual Result<std::unique_ptr<Lock>> lock(const std::string& path) = 0;
  // Whether there was one.
  virtual bool remove(const std::string& path) = 0;
};

Disk& this_disk();

}  // namespace pizarra::journal
