#include "programs/commands/picture_folder.hpp"

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace pizarra::programs {

namespace {

namespace files = std::filesystem;

constexpr const char* name_before_pid = "pizarra-pictures-";

bool is_own_folder(const files::path& path) {
  struct stat status {};
  return lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid();
}

// A store that works there holds a lock, also one whose process has another number elsewhere.
bool is_locked(const files::path& folder) {
  const int lock = ::open((folder / "lock").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW);
  if (lock < 0) return false;
  const bool free = flock(lock, LOCK_EX | LOCK_NB) == 0;
  close(lock);
  return !free;
}

bool is_left_over(const files::path& folder) {
  int pid = 0;
  const std::string pattern = std::string(name_before_pid) + "%d-";
  if (std::sscanf(folder.filename().c_str(), pattern.c_str(), &pid) != 1 || pid <= 0) return false;
  const bool is_gone = kill(pid, 0) != 0 && errno == ESRCH;
  return is_gone && is_own_folder(folder) && !is_locked(folder);
}

void remove_left_overs(const files::path& among) {
  std::error_code error;
  for (const auto& entry : files::directory_iterator(among, error)) {
    if (is_left_over(entry.path())) files::remove_all(entry.path(), error);
  }
}

}  // namespace

PictureFolder::PictureFolder(const files::path& among)
    : path_((among / fmt::format("{}{}-XXXXXX", name_before_pid, getpid())).string()) {
  remove_left_overs(among);
  made_ = mkdtemp(path_.data()) != nullptr;
}

PictureFolder::~PictureFolder() {
  std::error_code error;
  if (made_) files::remove_all(path_, error);
}

}  // namespace pizarra::programs
