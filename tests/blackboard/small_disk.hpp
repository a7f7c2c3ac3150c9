#pragma once

// A disk in memory, as small as a test wants it, that this process and its children alone see.
//
//   SmallDisk disk("16m");
//   if (!disk.mounted()) GTEST_SKIP() << "a file system is root's to mount";
//   disk.fill();                       // somebody else takes what is left ...
//   disk.clear();                      // ... and gives it back

#include <filesystem>
#include <fstream>
#include <sched.h>
#include <string>
#include <sys/mount.h>

#include "tests/scratch.hpp"

namespace pizarra {

class SmallDisk {
 public:
  explicit SmallDisk(const std::string& size) {
    std::filesystem::create_directory(folder_);
    mounted_ = unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
               mount("tmpfs", folder_.c_str(), "tmpfs", 0, ("size=" + size).c_str()) == 0;
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  ~SmallDisk() {
    if (mounted_) umount(folder_.c_str());
  }

  bool mounted() const { return mounted_; }
  std::string file(const std::string& name) const { return folder_ + "/" + name; }
  void fill() const {
    std::ofstream other(file("other"), std::ios::binary);
    const std::string block(4096, 'y');
    while (other.write(block.data(), static_cast<std::streamsize>(block.size())) && other.flush()) {
    }
  }
  void clear() const { std::filesystem::remove(file("other")); }

 private:
  const std::string folder_ = scratch_folder() + "disk";
  bool mounted_ = false;
};

}  // namespace pizarra
