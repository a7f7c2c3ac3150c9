#pragma once

// A disk in memory that a journal is kept on: it may be full, fail, be slow, and lose in a power cut what nobody waited
// for. SQLite uses it as a VFS.
//
//   SimulatedDisk disk(Random(seed));
//   Result<std::shared_ptr<journal::JournalFile>> file = journal::JournalFile::open("cell.journal", {}, disk);
//   disk.set_capacity(disk.used());       // full from now on
//   disk.fail(true);                      // whatever is written or flushed fails
//   disk.set_flush_time(300ms);           // what a flush takes: on_wait is told
//   disk.detach();                        // its process was killed: what has been opened touches it no more
//   disk.cut_power();                     // and what was not flushed is there or is not, piece by piece
//
// It outlives what was opened on it. One thread uses it.

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "blackboard/journal/disk.hpp"
#include "blackboard/time/clock.hpp"
#include "blackboard/time/random.hpp"

namespace pizarra::simulated {

struct DiskFile;

class SimulatedDisk : public journal::Disk {
 public:
  static constexpr std::int64_t plenty = std::int64_t{1} << 40;

  explicit SimulatedDisk(Random random);
  SimulatedDisk(const SimulatedDisk&) = delete;
  SimulatedDisk& operator=(const SimulatedDisk&) = delete;
  ~SimulatedDisk() override;

  const char* vfs() const override { return vfs_name_.c_str(); }
  std::optional<Status> status(const std::string& path) const override;
  std::unique_ptr<File> open(const std::string& path, Access access) override;
  Result<std::unique_ptr<Lock>> lock(const std::string& path) override;
  bool remove(const std::string& path) override;

  void set_capacity(std::int64_t bytes) { capacity_ = bytes; }
  std::int64_t used() const;
  void fail(bool fails) { fails_ = fails; }
  void set_flush_time(Duration time) { flush_time_ = time; }
  // It says that it flushed, and did not.
  void lie(bool lies) { lies_ = lies; }
  // Nothing stands on it any more; while nobody has it open.
  void erase() { files_.clear(); }
  std::function<void(Duration)> on_wait;

  void detach();
  void cut_power();

  // For the VFS's functions, which SQLite calls.
  std::shared_ptr<DiskFile> find(const std::string& path) const;
  std::shared_ptr<DiskFile> find_or_make(const std::string& path);
  std::uint64_t life() const { return life_; }
  bool fails() const { return fails_; }
  std::int64_t free_bytes() const { return std::max<std::int64_t>(capacity_ - used(), 0); }
  // Whether a file may have so many bytes.
  bool has_space(const DiskFile& file, std::int64_t bytes) const;
  void flush(DiskFile& file);
  Random& random() { return random_; }

 private:
  struct Vfs;

  Random random_;
  std::string vfs_name_;
  std::unique_ptr<Vfs> vfs_;
  std::map<std::string, std::shared_ptr<DiskFile>> files_;
  std::int64_t capacity_ = plenty;
  bool fails_ = false;
  bool lies_ = false;
  Duration flush_time_{};
  std::uint64_t life_ = 1;
  std::uint64_t next_file_ = 1;
};

}  // namespace pizarra::simulated
