#include "blackboard/simulated/simulated_disk.hpp"

#include <algorithm>
#include <atomic>

#include "blackboard/simulated/disk_file.hpp"
#include "blackboard/simulated/disk_vfs.hpp"

namespace pizarra::simulated {

namespace {

// SQLite tells its disks apart by name.
std::string new_name() {
  static std::atomic<int> disks = 0;
  return "pizarra-simulated-" + std::to_string(++disks);
}

class HeldLock : public journal::Disk::Lock {
 public:
  HeldLock(SimulatedDisk& disk, std::shared_ptr<DiskFile> file)
      : disk_(disk), life_(disk.life()), file_(std::move(file)) {}
  ~HeldLock() override {
    if (life_ == disk_.life()) file_->locked = false;
  }

 private:
  SimulatedDisk& disk_;
  const std::uint64_t life_;
  const std::shared_ptr<DiskFile> file_;
};

class OpenedFile : public journal::Disk::File {
 public:
  OpenedFile(SimulatedDisk& disk, std::shared_ptr<DiskFile> file)
      : disk_(disk), life_(disk.life()), file_(std::move(file)) {}

  std::int64_t bytes() const override { return static_cast<std::int64_t>(file_->data.size()); }
  std::string read(std::size_t most) const override { return file_->data.substr(0, most); }

  bool write_at(std::int64_t offset, std::string_view text) override {
    const std::int64_t end = offset + static_cast<std::int64_t>(text.size());
    if (!may_write() || !disk_.has_space(*file_, end)) return false;
    file_->write(offset, text);
    return true;
  }

  bool set_aside(std::int64_t wanted) override {
    if (!may_write() || !disk_.has_space(*file_, wanted)) return false;
    file_->set_aside = wanted;
    return true;
  }

  std::int64_t free_bytes() const override { return disk_.free_bytes(); }

 private:
  bool may_write() const { return life_ == disk_.life() && !disk_.fails(); }

  SimulatedDisk& disk_;
  const std::uint64_t life_;
  const std::shared_ptr<DiskFile> file_;
};

std::int64_t space_of(const DiskFile& file) {
  return std::max(static_cast<std::int64_t>(file.data.size()), file.set_aside);
}

}  // namespace

struct SimulatedDisk::Vfs {
  sqlite3_vfs vfs;
};

SimulatedDisk::SimulatedDisk(Random random)
    : random_(std::move(random)), vfs_name_(new_name()), vfs_(new Vfs{vfs_of(*this, vfs_name_.c_str())}) {
  sqlite3_vfs_register(&vfs_->vfs, 0);
}

SimulatedDisk::~SimulatedDisk() { sqlite3_vfs_unregister(&vfs_->vfs); }

std::shared_ptr<DiskFile> SimulatedDisk::find(const std::string& path) const {
  const auto found = files_.find(path);
  return found == files_.end() ? nullptr : found->second;
}

std::shared_ptr<DiskFile> SimulatedDisk::find_or_make(const std::string& path) {
  std::shared_ptr<DiskFile>& file = files_[path];
  if (file == nullptr) file = std::make_shared<DiskFile>(next_file_++);
  return file;
}

std::optional<journal::Disk::Status> SimulatedDisk::status(const std::string& path) const {
  const std::shared_ptr<DiskFile> file = find(path);
  if (file == nullptr) return std::nullopt;
  return Status{{1, file->number}, static_cast<std::int64_t>(file->data.size())};
}

std::unique_ptr<journal::Disk::File> SimulatedDisk::open(const std::string& path, Access access) {
  std::shared_ptr<DiskFile> file = find(path);
  if (file == nullptr && (access == Access::read || fails_)) return nullptr;
  if (file == nullptr) file = find_or_make(path);
  return std::make_unique<OpenedFile>(*this, std::move(file));
}

Result<std::unique_ptr<journal::Disk::Lock>> SimulatedDisk::lock(const std::string& path) {
  if (find(path) == nullptr && fails_) return pizarra::fail("journal-file", "cannot open " + path);
  const std::shared_ptr<DiskFile> file = find_or_make(path);
  if (file->locked) return pizarra::fail("journal-file", "another board keeps " + path);
  file->locked = true;
  return std::make_unique<HeldLock>(*this, file);
}

bool SimulatedDisk::remove(const std::string& path) { return files_.erase(path) > 0; }

std::int64_t SimulatedDisk::used() const {
  std::int64_t bytes = 0;
  for (const auto& [path, file] : files_) bytes += space_of(*file);
  return bytes;
}

bool SimulatedDisk::has_space(const DiskFile& file, std::int64_t bytes) const {
  return bytes <= space_of(file) || used() - space_of(file) + bytes <= capacity_;
}

void SimulatedDisk::flush(DiskFile& file) {
  if (!lies_) file.flushed();
  if (on_wait && flush_time_ > Duration::zero()) on_wait(flush_time_);
}

void SimulatedDisk::detach() {
  ++life_;
  for (const auto& [path, file] : files_) file->forget_its_users();
}

void SimulatedDisk::cut_power() {
  detach();
  for (const auto& [path, file] : files_) file->lose_some(random_);
}

}  // namespace pizarra::simulated
