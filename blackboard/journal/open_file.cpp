#include "blackboard/journal/open_file.hpp"

#include <sys/stat.h>

namespace pizarra {

OpenFile::OpenFile(std::string path) : path_(std::move(path)), file_(at(path_)) {}

std::optional<OpenFile::Identity> OpenFile::at(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return Identity(status.st_dev, status.st_ino);
}

}  // namespace pizarra
