#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include "blackboard/journal/disk.hpp"

namespace pizarra::journal {

namespace {

class OpenDescriptor : public Disk::Lock, public Disk::File {
 public:
  explicit OpenDescriptor(int file) : file_(file) {}
  OpenDescriptor(const OpenDescriptor&) = delete;
  OpenDescriptor& operator=(const OpenDescriptor&) = delete;
  ~OpenDescriptor() override { close(file_); }

  std::int64_t bytes() const override {
    struct stat status {};
    return fstat(file_, &status) == 0 ? status.st_size : 0;
  }

  std::string read(std::size_t most) const override {
    std::string text(most, '\0');
    const ssize_t length = pread(file_, text.data(), most, 0);
    text.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
    return text;
  }

  bool write_at(std::int64_t offset, std::string_view text) override {
    return pwrite(file_, text.data(), text.size(), offset) == static_cast<ssize_t>(text.size());
  }

  bool set_aside(std::int64_t wanted) override {
    const std::int64_t before = bytes();
    if (posix_fallocate(file_, 0, wanted) == 0) return true;
    // What could be had of it is given back. That it cannot be is the system's to say when it is used.
    [[maybe_unused]] const int cut = ftruncate(file_, before);
    return false;
  }

  std::int64_t free_bytes() const override {
    struct statvfs disk {};
    if (fstatvfs(file_, &disk) != 0) return 0;
    return static_cast<std::int64_t>(disk.f_bavail) * static_cast<std::int64_t>(disk.f_frsize);
  }

 private:
  const int file_;
};

std::unexpected<Failure> refused(const std::string& what, const std::string& path) {
  return fail("journal-file", what + " " + path + ": " + std::strerror(errno));
}

class ThisDisk : public Disk {
 public:
  const char* vfs() const override { return nullptr; }

  std::optional<Status> status(const std::string& path) const override {
    struct stat status {};
    if (stat(path.c_str(), &status) != 0) return std::nullopt;
    return Status{{status.st_dev, status.st_ino}, status.st_size};
  }

  std::unique_ptr<File> open(const std::string& path, Access access) override {
    const int flags = access == Access::read ? O_RDONLY : O_RDWR | O_CREAT;
    const int file = ::open(path.c_str(), flags | O_CLOEXEC, 0644);
    return file < 0 ? nullptr : std::make_unique<OpenDescriptor>(file);
  }

  Result<std::unique_ptr<Lock>> lock(const std::string& path) override {
    const int file = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (file < 0) return refused("cannot open", path);
    auto lock = std::make_unique<OpenDescriptor>(file);
    if (flock(file, LOCK_EX | LOCK_NB) != 0) return refused("another board keeps", path);
    return lock;
  }

  bool remove(const std::string& path) override { return unlink(path.c_str()) == 0; }
};

}  // namespace

// It outlives every journal, those of static storage too.
Disk& this_disk() {
  static Disk& disk = *new ThisDisk;
  return disk;
}

}  // namespace pizarra::journal
