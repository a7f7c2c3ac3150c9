#include "agents/scheme/program_file.hpp"

#include <filesystem>

#include "lisp/reader.hpp"

namespace pizarra::scheme {

namespace {

constexpr ReadLimits limits{.bytes = 1 << 18};

}  // namespace

ProgramFile::Stamp ProgramFile::stamp() const {
  struct stat found {};
  if (stat(path_.c_str(), &found) != 0) return {};
  return {found.st_ino, found.st_size, found.st_mtim.tv_sec, found.st_mtim.tv_nsec};
}

std::optional<Result<std::string>> ProgramFile::look() {
  const Stamp now = stamp();
  if (seen_ == now) return std::nullopt;
  // Before it is read: what is saved meanwhile is seen by the next look.
  seen_ = now;
  return read_text_file(path_, limits);
}

std::string ProgramFile::name() const { return std::filesystem::path(path_).filename().string(); }

}  // namespace pizarra::scheme
