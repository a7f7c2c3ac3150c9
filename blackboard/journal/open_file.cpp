#include "blackboard/journal/open_file.hpp"

namespace pizarra::journal {

OpenFile::OpenFile(const Disk& disk, std::string path) : disk_(disk), path_(std::move(path)) {
  if (const auto status = disk_.status(path_)) file_ = status->file;
}

bool OpenFile::is_there(std::int64_t least_bytes) const {
  if (!file_) return true;
  const auto status = disk_.status(path_);
  return status && status->file == *file_ && status->bytes >= least_bytes;
}

std::int64_t OpenFile::bytes() const {
  const auto status = disk_.status(path_);
  return status ? status->bytes : 0;
}

}  // namespace pizarra::journal
