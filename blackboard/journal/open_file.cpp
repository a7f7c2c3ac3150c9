#include "blackboard/journal/open_file.hpp"

#include <sys/stat.h>

namespace pizarra::journal {

namespace {

std::optional<struct stat> status_of(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return status;
}

}  // namespace

OpenFile::OpenFile(std::string path) : path_(std::move(path)) {
  if (const auto status = status_of(path_)) file_.emplace(status->st_dev, status->st_ino);
}

bool OpenFile::is_there(std::int64_t least_bytes) const {
  if (!file_) return true;
  const auto status = status_of(path_);
  return status && Identity(status->st_dev, status->st_ino) == *file_ && status->st_size >= least_bytes;
}

std::int64_t OpenFile::bytes() const {
  const auto status = status_of(path_);
  return status ? status->st_size : 0;
}

}  // namespace pizarra::journal
