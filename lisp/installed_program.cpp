#include "lisp/installed_program.hpp"

#include <cstdlib>
#include <sstream>
#include <unistd.h>

namespace pizarra {

std::optional<std::string> installed_program(std::string_view name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(std::string(path == nullptr ? "" : path) + ":/usr/bin:/usr/sbin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (folder.empty()) continue;
    std::string program = folder.append("/").append(name);
    if (access(program.c_str(), X_OK) == 0) return program;
  }
  return std::nullopt;
}

}  // namespace pizarra
