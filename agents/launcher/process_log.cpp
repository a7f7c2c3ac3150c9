#include "agents/launcher/process_log.hpp"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <fstream>

namespace pizarra::launcher {

namespace {

constexpr const char* ending = ".log";

}  // namespace

std::string process_log_name(const std::string& process) { return process + ending; }

bool is_process_log(const std::filesystem::path& file) { return file.extension() == ending; }

Result<int> open_process_log(const std::string& path) {
  const int log = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (log >= 0) return log;
  return fail("cannot-start", fmt::format("cannot write {}: {}", path, std::strerror(errno)));
}

std::string last_line_of_log(const std::string& path) {
  std::ifstream in(path);
  std::string last;
  for (std::string line; std::getline(in, line);) {
    if (!line.empty()) last = line;
  }
  return last;
}

}  // namespace pizarra::launcher
