#include "agents/vision/database/file_states.hpp"

#include <algorithm>
#include <sys/stat.h>

namespace pizarra::vision {

bool FileStates::unchanged() const {
  return std::ranges::all_of(noted_, [](const auto& entry) { return state_of(entry.first) == entry.second; });
}

std::optional<FileStates::State> FileStates::state_of(const std::filesystem::path& file) {
  struct stat found {};
  if (::stat(file.c_str(), &found) != 0) return std::nullopt;
  return State{found.st_ino, found.st_size, found.st_ctim.tv_sec, found.st_ctim.tv_nsec};
}

}  // namespace pizarra::vision
